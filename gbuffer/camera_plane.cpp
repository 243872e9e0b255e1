// A camera from one plane: its homography and two orthogonal directions of equal length in it (Zhang 2000, "A Flexible New Technique for Camera
// Calibration", 2.3 and 3.1, with one view and one unknown).
#include "gbuffer/camera_plane.h"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"  // g++ 12 suspects a scalar inside Eigen 3.4's triangular product
#endif

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "gbuffer/camera_refinement.h"
#include "gbuffer/median.h"

namespace relume {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

struct Plane {
  Vector3d centre{0, 0, 0};
  Matrix3d axes;  ///< two along it, then its normal; right-handed
  double size = 0;
};

Plane plane_of(const std::vector<Sighting>& sightings) {
  Plane plane;
  Matrix3d spread = Matrix3d::Zero();
  const auto at = [](const Sighting& s) { return Vector3d(s.position.x, s.position.y, s.position.z); };
  for (const Sighting& s : sightings) plane.centre += at(s) / double(sightings.size());
  for (const Sighting& s : sightings) spread += (at(s) - plane.centre) * (at(s) - plane.centre).transpose() / double(sightings.size());
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(spread);  // the smallest first
  plane.axes << solver.eigenvectors().col(2), solver.eigenvectors().col(1), solver.eigenvectors().col(2).cross(solver.eigenvectors().col(1));
  plane.size = std::sqrt(solver.eigenvalues()(2));
  return plane;
}

/// Pixels as offsets from the optical axis, y up, in units of `unit` that make both axes alike.
struct Film {
  double centre_x, centre_y, unit_x, unit_y;
};

/// From places in the plane, in units of its size, to the film.
Matrix3d homography_of(const std::vector<Sighting>& sightings, const Plane& plane, const Film& film) {
  Eigen::MatrixXd system(2 * Eigen::Index(sightings.size()), 9);
  for (Eigen::Index i = 0; i < Eigen::Index(sightings.size()); ++i) {
    const Sighting& s = sightings[std::size_t(i)];
    const Vector3d local = plane.axes.transpose() * (Vector3d(s.position.x, s.position.y, s.position.z) - plane.centre) / plane.size;
    const Eigen::RowVector3d p(local.x(), local.y(), 1), none = Eigen::RowVector3d::Zero();
    const double u = (s.x - film.centre_x) / film.unit_x, v = -(s.y - film.centre_y) / film.unit_y;
    system.row(2 * i) << p, none, -u * p;
    system.row(2 * i + 1) << none, p, -v * p;
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(system, Eigen::ComputeFullV);
  const Eigen::VectorXd h = svd.matrixV().col(8);
  Matrix3d homography;
  homography << h.segment<3>(0).transpose(), h.segment<3>(3).transpose(), h.segment<3>(6).transpose();
  return homography(2, 2) < 0 ? Matrix3d(-homography) : homography;  // the middle lies in front
}

/// Median distance in pixels between where the homography shows places and where they were seen.
double error_of(const Matrix3d& h, const std::vector<Sighting>& sightings, const Plane& plane, const Film& film) {
  std::vector<double> errors;
  for (const Sighting& s : sightings) {
    const Vector3d local = plane.axes.transpose() * (Vector3d(s.position.x, s.position.y, s.position.z) - plane.centre) / plane.size;
    const Vector3d p = h * Vector3d(local.x(), local.y(), 1);
    errors.push_back(std::hypot(film.centre_x + film.unit_x * p.x() / p.z() - s.x, film.centre_y - film.unit_y * p.y() / p.z() - s.y));
  }
  return median(std::move(errors));
}

/// In units of the film: what makes the plane's axes perpendicular and alike; not positive where it is seen head on.
double focal_of(const Matrix3d& h) {
  const Eigen::Vector2d across(h(0, 0) * h(0, 1) + h(1, 0) * h(1, 1), h.col(0).head<2>().squaredNorm() - h.col(1).head<2>().squaredNorm()),
      along(h(2, 0) * h(2, 1), h(2, 0) * h(2, 0) - h(2, 1) * h(2, 1));
  const double squared = -across.squaredNorm() / across.dot(along);  // least squares of across / f^2 + along = 0
  return squared > 0 && std::isfinite(squared) ? std::sqrt(squared) : 0;
}

glm::dvec4 column(const Vector3d& v, double w) { return {v.x(), v.y(), v.z(), w}; }

/// `side`: 1 or -1, which of the plane's sides the eye is on.
Camera posed(const Matrix3d& h, double focal, const Plane& plane, double side) {
  Matrix3d g = h;
  g.topRows<2>() /= focal;
  g.row(2) *= -1;  // the camera looks along -z
  g /= 0.5 * (g.col(0).norm() + g.col(1).norm());
  const Vector3d sum = (g.col(0).normalized() + g.col(1).normalized()).normalized(), difference = (g.col(0).normalized() - g.col(1).normalized());
  const Vector3d across = (difference - sum * sum.dot(difference)).normalized(), r1 = (sum + across).normalized(), r2 = (sum - across).normalized();
  const Vector3d t = g.col(2) * plane.size;
  Vector3d r3 = r1.cross(r2);
  if (-r3.dot(t) * side < 0) r3 = -r3;
  Matrix3d camera_from_plane;
  camera_from_plane << r1, r2, r3;
  const Matrix3d axes = plane.axes * camera_from_plane.transpose();
  const Vector3d eye = plane.centre - axes * t;
  Camera camera;
  camera.world_from_camera = {column(axes.col(0), 0), column(axes.col(1), 0), column(axes.col(2), 0), column(eye, 1)};
  return camera;
}

/// The side that most normals point to; 0 where they do not tell.
double side_of(const std::vector<glm::dvec3>& normals, const Plane& plane) {
  double sum = 0;
  for (const glm::dvec3& n : normals) sum += plane.axes.col(2).dot(Vector3d(n.x, n.y, n.z));
  return std::abs(sum) > 0.5 * double(normals.size()) ? (sum > 0 ? 1 : -1) : 0;
}

struct Solution {
  Camera camera;
  double free = 0;  ///< pixels that are left where the image may be any of a plane, by whatever lens
};

std::optional<Solution> solved(const std::vector<Sighting>& sightings, double side, const Plane& plane, const Window& display, double pixel_aspect,
                               const std::optional<Lens>& lens) {
  const double middle_x = 0.5 * (display.min_x + display.max_x), middle_y = 0.5 * (display.min_y + display.max_y), unit = display.height();
  const Film film = lens ? Film{lens->centre_x, lens->centre_y, lens->scale_x, lens->scale_y} : Film{middle_x, middle_y, unit, unit * pixel_aspect};
  const Matrix3d h = homography_of(sightings, plane, film);
  const double focal = lens ? 1 : focal_of(h);
  if (!(focal > 0)) return {};
  Camera camera = posed(h, focal, plane, side == 0 ? 1 : side);
  if (side == 0 && glm::determinant(glm::dmat3(camera.world_from_camera)) < 0) camera = posed(h, focal, plane, -1);
  camera.lens = Lens{focal * film.unit_x, focal * film.unit_y, film.centre_x, film.centre_y};
  refine(camera, sightings, true);
  return Solution{camera, error_of(h, sightings, plane, film)};
}

}  // namespace

std::optional<Camera> camera_of_plane(const std::vector<Sighting>& sightings, const std::vector<glm::dvec3>& normals, const Window& display,
                                      double pixel_aspect, const std::optional<Lens>& lens, double max_residual) {
  constexpr std::size_t shares = 3, enough = 24;
  if (sightings.size() < enough) return {};
  const Plane plane = plane_of(sightings);
  const double side = side_of(normals, plane);
  const auto whole = solved(sightings, side, plane, display, pixel_aspect, lens);
  if (!whole) return {};
  Camera camera = whole->camera;
  camera.residual = reprojection_error(camera, sightings);
  // Seen from behind, or in a left-handed world: the plane does not tell which.
  if (glm::determinant(glm::dmat3(camera.world_from_camera)) < 0) return {};
  // A lens of another kind leaves more than the positions' own rounding.
  if (!(camera.residual <= max_residual) || camera.residual > 1.5 * whole->free + 1e-3) return {};
  for (std::size_t share = 0; share < shares; ++share) {  // what does not determine a camera answers at random
    std::vector<Sighting> part;
    for (std::size_t i = share; i < sightings.size(); i += shares) part.push_back(sightings[i]);
    const auto other = solved(part, side, plane, display, pixel_aspect, lens);
    constexpr double too_uncertain = 0.005;  // of the distance, as recover() has it between thirds
    const glm::dvec3 centre(plane.centre.x(), plane.centre.y(), plane.centre.z());
    if (!other || !(glm::distance(other->camera.eye(), camera.eye()) < too_uncertain * glm::distance(camera.eye(), centre))) return {};
  }
  set_extent(camera, *camera.lens, display);
  camera.assumed_lens = !lens;
  camera.recovered = true;
  camera.source = "recovered from one plane";
  return camera;
}

}  // namespace relume
