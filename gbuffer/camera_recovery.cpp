// Cameras from positions: resectioning by the direct linear transform, Hartley and Zisserman 2004, "Multiple View Geometry", ch. 7,
// with normalised coordinates, reweighted towards the reprojection error (their 4.2) and against outliers (Cauchy weights).
#include "gbuffer/camera.h"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"  // g++ 12 suspects a scalar inside Eigen 3.4's triangular product
#endif

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <random>

#include "gbuffer/camera_refinement.h"
#include "gbuffer/median.h"

namespace relume {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Projection34 = Eigen::Matrix<double, 3, 4>;

Vector3d eigen(const glm::dvec3& v) { return {v.x, v.y, v.z}; }
glm::dvec3 glm_of(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// Moves and scales points to mean 0 and mean distance sqrt(dimension): without it the system is ill-conditioned (H&Z 4.4.4).
struct Normaliser {
  Vector3d world_centre{0, 0, 0};
  double world_scale = 1, centre_x = 0, centre_y = 0, pixel_scale = 1;

  explicit Normaliser(const std::vector<Sighting>& sightings) {
    const double n = double(sightings.size());
    for (const Sighting& s : sightings) {
      world_centre += eigen(s.position) / n;
      centre_x += s.x / n;
      centre_y += s.y / n;
    }
    double world = 0, pixel = 0;
    for (const Sighting& s : sightings) {
      world += (eigen(s.position) - world_centre).norm() / n;
      pixel += std::hypot(s.x - centre_x, s.y - centre_y) / n;
    }
    world_scale = world > 0 ? std::sqrt(3.0) / world : 1;
    pixel_scale = pixel > 0 ? std::sqrt(2.0) / pixel : 1;
  }

  Eigen::Vector4d world(const Sighting& s) const {
    Eigen::Vector4d point;
    point << (eigen(s.position) - world_centre) * world_scale, 1;
    return point;
  }
  double x(const Sighting& s) const { return (s.x - centre_x) * pixel_scale; }
  double y(const Sighting& s) const { return (s.y - centre_y) * pixel_scale; }

  /// A projection of normalised points to normalised pixels as one of world points to pixels.
  Projection34 undone(const Projection34& normal) const {
    Eigen::Matrix3d pixels;
    pixels << 1 / pixel_scale, 0, centre_x, 0, 1 / pixel_scale, centre_y, 0, 0, 1;
    Eigen::Matrix4d points = Eigen::Matrix4d::Identity();
    points.topLeftCorner<3, 3>() *= world_scale;
    points.topRightCorner<3, 1>() = -world_scale * world_centre;
    return pixels * normal * points;
  }
};

struct Fit {
  Projection34 projection = Projection34::Zero();
  bool determined = false;
  double residual = std::numeric_limits<double>::infinity();  ///< median, pixels
  double share_off = 1;                                       ///< mean of the errors, each at most one pixel: the median overlooks a minority
};

/// Right singular vector of the smallest singular value, and whether it is the only small one.
Fit smallest(const MatrixXd& system) {
  const Eigen::JacobiSVD<MatrixXd> svd(system, Eigen::ComputeFullV);  // reduced by QR first: the system itself, not its square
  Fit fit;
  fit.determined = svd.singularValues()(10) > 1e-10 * svd.singularValues()(0);  // else another camera fits as exactly: all points in one plane
  const VectorXd p = svd.matrixV().col(11);
  fit.projection << p.segment<4>(0).transpose(), p.segment<4>(4).transpose(), p.segment<4>(8).transpose();
  return fit;
}

Fit solve_perspective(const std::vector<Sighting>& sightings, const Normaliser& normaliser, const VectorXd& weights) {
  MatrixXd system(2 * Eigen::Index(sightings.size()), 12);
  for (Eigen::Index i = 0; i < Eigen::Index(sightings.size()); ++i) {
    const Sighting& s = sightings[std::size_t(i)];
    const Eigen::RowVector4d point = normaliser.world(s).transpose(), none = Eigen::RowVector4d::Zero();
    system.row(2 * i) << point, none, -normaliser.x(s) * point;
    system.row(2 * i + 1) << none, point, -normaliser.y(s) * point;
    system.middleRows(2 * i, 2) *= weights(i);
  }
  return smallest(system);
}

Fit solve_orthographic(const std::vector<Sighting>& sightings, const Normaliser& normaliser, const VectorXd& weights) {
  const Eigen::Index n = Eigen::Index(sightings.size());
  MatrixXd points(n, 4), pixels(n, 2);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Sighting& s = sightings[std::size_t(i)];
    points.row(i) = weights(i) * normaliser.world(s).transpose();
    pixels.row(i) << weights(i) * normaliser.x(s), weights(i) * normaliser.y(s);
  }
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(points);
  Fit fit;
  fit.determined = std::abs(qr.matrixR()(3, 3)) > 1e-10 * std::abs(qr.matrixR()(0, 0));
  fit.projection.topRows<2>() = qr.solve(pixels).transpose();
  fit.projection.row(2) << 0, 0, 0, 1;
  return fit;
}

/// Iteratively reweighted: divided by depth, the algebraic error becomes the reprojection error; Cauchy weights quieten outliers.
template <class Solve>
Fit fitted(const std::vector<Sighting>& sightings, Solve&& solve) {
  constexpr int rounds = 8;  // converges in 3 or 4 on clean positions; outliers need the rest
  const Normaliser normaliser(sightings);
  VectorXd weights = VectorXd::Ones(Eigen::Index(sightings.size()));
  Fit best;
  for (int round = 0; round < rounds; ++round) {
    Fit fit = solve(sightings, normaliser, weights);
    std::vector<double> depths, errors;
    for (const Sighting& s : sightings) {
      const Vector3d p = fit.projection * normaliser.world(s);
      depths.push_back(std::abs(p.z()));
      errors.push_back(std::hypot(p.x() / p.z() - normaliser.x(s), p.y() / p.z() - normaliser.y(s)));
    }
    const double typical = median(errors), depth = median(depths);
    fit.residual = typical / normaliser.pixel_scale;
    fit.share_off = 0;
    for (const double error : errors) fit.share_off += (error < normaliser.pixel_scale ? error / normaliser.pixel_scale : 1) / double(errors.size());
    fit.projection = normaliser.undone(fit.projection);
    if (fit.residual < best.residual || round == 0) best = fit;
    const double width = std::max(2 * typical, 1e-9);  // twice the median is about one and a half standard deviations
    for (Eigen::Index i = 0; i < weights.size(); ++i) {
      const double error = errors[std::size_t(i)] / width, far = std::max(depths[std::size_t(i)] / depth, 1e-3);
      weights(i) = std::isfinite(error) ? 1 / (far * std::sqrt(1 + error * error)) : 0;
    }
  }
  return best;
}

bool flat(const std::vector<Sighting>& sightings) {
  const Normaliser normaliser(sightings);
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Sighting& s : sightings) {
    const Vector3d p = normaliser.world(s).head<3>();
    spread += p * p.transpose();
  }
  const Vector3d values = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvalues();
  return values(0) <= 1e-10 * values(2);  // thinner than a 100000th of its extent: single precision cannot tell it from a plane
}

/// Right and up made perpendicular to backward and to each other, turned equally; their handedness is kept.
glm::dmat4 square_frame(Vector3d right, Vector3d up, const Vector3d& backward, const Vector3d& eye) {
  const double hand = right.cross(up).dot(backward) < 0 ? -1 : 1;
  right = (right - backward * right.dot(backward)).normalized();
  up = (up - backward * up.dot(backward)).normalized();
  const Vector3d middle = (right + up).normalized(), across = hand * backward.cross(middle);
  right = (middle - across).normalized(), up = (middle + across).normalized();
  return {glm::dvec4(glm_of(right), 0), glm::dvec4(glm_of(up), 0), glm::dvec4(glm_of(backward), 0), glm::dvec4(glm_of(eye), 1)};
}

Camera perspective_camera(Projection34 p, const std::vector<Sighting>& sightings) {
  std::size_t in_front = 0;
  for (const Sighting& s : sightings) in_front += p.row(2).head<3>().dot(eigen(s.position)) + p(2, 3) > 0;
  if (2 * in_front < sightings.size()) p = -p;
  p /= p.row(2).head<3>().norm();
  const Vector3d x = p.row(0).head<3>(), y = p.row(1).head<3>(), forward = p.row(2).head<3>();
  const double centre_x = x.dot(forward), centre_y = y.dot(forward);
  const Vector3d right = x - centre_x * forward, down = y - centre_y * forward;
  const Vector3d eye = -p.leftCols<3>().fullPivLu().solve(p.col(3));
  Camera camera;
  camera.world_from_camera = square_frame(right.normalized(), -down.normalized(), -forward, eye);
  camera.lens = Lens{right.norm(), down.norm(), centre_x, centre_y};
  return camera;
}

/// Positions alone do not tell a mirrored world from a view from behind: a right-handed world is taken.
Camera orthographic_camera(const Projection34& p, const std::vector<Sighting>& sightings, const Window& display) {
  const Vector3d x = p.row(0).head<3>(), down = p.row(1).head<3>();
  const Vector3d right = x.normalized(), up = -down.normalized(), backward = right.cross(up).normalized();
  Vector3d centre{0, 0, 0};
  double reach = 0;
  for (const Sighting& s : sightings) centre += eigen(s.position) / double(sightings.size());
  for (const Sighting& s : sightings) reach = std::max(reach, (eigen(s.position) - centre).norm());
  Camera camera;
  camera.projection = Camera::Projection::orthographic;
  // On the middle of the window, clear of everything seen.
  camera.lens = Lens{x.norm(), down.norm(), 0.5 * (display.min_x + display.max_x), 0.5 * (display.min_y + display.max_y)};
  const double off_x = camera.lens->centre_x - (x.dot(centre) + p(0, 3)), off_y = camera.lens->centre_y - (down.dot(centre) + p(1, 3));
  const Vector3d eye = centre + right * (off_x / x.norm()) - up * (off_y / down.norm()) + backward * 2 * reach;
  camera.world_from_camera = square_frame(right, up, backward, eye);
  return camera;
}

double reach_of(const std::vector<Sighting>& sightings, const glm::dvec3& eye) {
  std::vector<double> distances;
  for (const Sighting& s : sightings) distances.push_back(glm::distance(s.position, eye));
  return median(distances);
}

Camera camera_of(const Fit& fit, bool orthographic, const std::vector<Sighting>& sightings, const Window& display) {
  return orthographic ? orthographic_camera(fit.projection, sightings, display) : perspective_camera(fit.projection, sightings);
}

/// How far apart thirds of the sightings put the viewer, as an angle at the scene. What does not determine a camera answers at random.
double disagreement(const std::vector<Sighting>& sightings, bool orthographic, const Window& display) {
  constexpr std::size_t shares = 3;  // two agree by luck too often
  std::vector<Sighting> parts[shares];
  for (std::size_t i = 0; i < sightings.size(); ++i) parts[i % shares].push_back(sightings[i]);
  Camera cameras[shares];
  for (std::size_t k = 0; k < shares; ++k) {
    const Fit fit = orthographic ? fitted(parts[k], solve_orthographic) : fitted(parts[k], solve_perspective);
    cameras[k] = camera_of(fit, orthographic, parts[k], display);
    refine(cameras[k], parts[k]);
  }
  double worst = 0;
  for (std::size_t k = 0; k < shares; ++k) {
    const Camera &a = cameras[k], &b = cameras[(k + 1) % shares];
    worst =
        std::max(worst, orthographic ? glm::distance(a.backward(), b.backward()) : glm::distance(a.eye(), b.eye()) / reach_of(sightings, a.eye()));
  }
  return worst;
}

Recovery recovered_from(const std::vector<Sighting>& sightings, const Window& display, double max_residual) {
  if (flat(sightings)) return {{}, "all positions lie in one plane", true};
  const Fit perspective = fitted(sightings, solve_perspective), affine = fitted(sightings, solve_orthographic);
  // A perspective camera fits an orthographic image too, only a little better; a thousandth of a pixel is what float positions leave.
  // Seen head-on, a floor that fills the picture fits an orthographic camera exactly: what stands on it does not.
  constexpr double things_on_it = 0.01;  // of the sightings, a pixel off
  const bool orthographic = affine.residual <= 1.1 * perspective.residual + 1e-3 && affine.share_off <= 1.1 * perspective.share_off + things_on_it;
  const Fit& fit = orthographic ? affine : perspective;
  if (!fit.determined) return {{}, "the positions fit many cameras alike", false};
  if (!(fit.residual <= max_residual))
    return {{}, "no camera sees the positions at their pixels (best: " + std::to_string(fit.residual) + " pixels off)", false};
  constexpr double too_uncertain = 0.01;  // half a degree of viewing direction: more is visible in highlights
  if (sightings.size() >= 24 && !(disagreement(sightings, orthographic, display) < too_uncertain))
    return {{}, "the positions lie too nearly in one plane", true};
  Camera camera = camera_of(fit, orthographic, sightings, display);
  refine(camera, sightings);
  set_extent(camera, *camera.lens, display);
  camera.recovered = true;
  camera.source = "recovered from the positions";
  return {camera, "", false};
}

std::vector<double> errors_of(const Projection34& projection, const std::vector<Sighting>& sightings) {
  std::vector<double> errors;
  for (const Sighting& s : sightings) {
    const Vector3d p = projection.leftCols<3>() * eigen(s.position) + projection.col(3);
    const double error = std::hypot(p.x() / p.z() - s.x, p.y() / p.z() - s.y);
    errors.push_back(std::isfinite(error) ? error : std::numeric_limits<double>::infinity());
  }
  return errors;
}

/// The sightings that go with the best of many cameras through a few of them each (least median of squares, Rousseeuw 1984): what is left when up
/// to a third were seen elsewhere.
std::vector<Sighting> consensus(const std::vector<Sighting>& sightings) {
  constexpr int trials = 400;       // with a third astray, 16 of them draw good sightings alone
  constexpr std::size_t drawn = 8;  // 6 determine a camera; 2 more steady it against rounding
  std::mt19937 random(1);
  std::vector<double> best(sightings.size(), std::numeric_limits<double>::infinity());
  double least = median(best);
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<Sighting> few;
    for (std::size_t i = 0; i < drawn; ++i) few.push_back(sightings[random() % sightings.size()]);
    const Normaliser normaliser(few);
    const Projection34 projection = normaliser.undone(solve_perspective(few, normaliser, VectorXd::Ones(drawn)).projection);
    std::vector<double> errors = errors_of(projection, sightings);
    if (const double middle = median(errors); middle < least) least = middle, best = std::move(errors);
  }
  std::vector<Sighting> kept;
  for (std::size_t i = 0; i < sightings.size(); ++i)
    if (best[i] <= 3 * least) kept.push_back(sightings[i]);
  return kept;
}

}  // namespace

Recovery recover(const std::vector<Sighting>& sightings, const Window& display, double max_residual) {
  if (sightings.size() < 8) return {{}, "only " + std::to_string(sightings.size()) + " usable positions", false};
  Recovery recovery = recovered_from(sightings, display, max_residual);
  constexpr std::size_t many = 64;  // fewer agree by chance
  if (!recovery.camera && sightings.size() >= many && !flat(sightings)) {
    const std::vector<Sighting> kept = consensus(sightings);
    const double share = double(kept.size()) / double(sightings.size());
    // Without strays a second try is another throw of the dice, not better knowledge.
    if (share > 0.5 && share < 0.95) recovery.camera = recovered_from(kept, display, max_residual).camera;
  }
  if (recovery.camera) recovery.camera->residual = reprojection_error(*recovery.camera, sightings);
  return recovery;
}

}  // namespace relume
