// Bundle adjustment of one camera: Levenberg-Marquardt on the reprojection error with Cauchy weights, Hartley and Zisserman 2004, 7.2 and A6.8.
#include "gbuffer/camera_refinement.h"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"  // g++ 12 suspects a scalar inside Eigen 3.4's triangular product
#endif

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "gbuffer/median.h"

namespace relume {
namespace {

/// Turn (3, in camera space), move (3, in camera space, in units of the scene's distance), lens scales (2, as factors) and centre (2, pixels).
constexpr int unknowns = 10;
using Step = Eigen::Matrix<double, unknowns, 1>;
using Rows = Eigen::Matrix<double, 2, unknowns>;

struct Normal {
  Eigen::Matrix<double, unknowns, unknowns> square = Eigen::Matrix<double, unknowns, unknowns>::Zero();
  Step right = Step::Zero();
  double cost = 0;
};

class Refiner {
 public:
  Refiner(const Camera& camera, const std::vector<Sighting>& sightings, bool fixed_lens)
      : sightings_(sightings), orthographic_(camera.projection == Camera::Projection::orthographic), fixed_lens_(fixed_lens) {
    width_ = std::max(2 * reprojection_error(camera, sightings), 1e-6);  // of the Cauchy weights: about one and a half standard deviations
    std::vector<double> distances;
    for (const Sighting& s : sightings) distances.push_back(glm::distance(s.position, camera.eye()));
    unit_ = std::max(median(std::move(distances)), std::numeric_limits<double>::min());
  }

  bool usable() const { return std::isfinite(width_) && std::isfinite(unit_); }

  Normal normal_equations(const Camera& camera) const {
    Normal normal;
    const glm::dmat4 camera_from_world = glm::inverse(camera.world_from_camera);
    for (const Sighting& s : sightings_) {
      const glm::dvec3 p(camera_from_world * glm::dvec4(s.position, 1));
      Eigen::Vector2d error;
      const Rows rows = derivatives(p, *camera.lens, s, error);
      if (!std::isfinite(error.squaredNorm()) || (!orthographic_ && p.z >= 0)) {
        normal.cost += std::log1p(1e6);  // as if far off, so that no step gains by passing points by
        continue;
      }
      const double off = error.squaredNorm() / (width_ * width_), weight = 1 / (1 + off);
      normal.square += weight * rows.transpose() * rows;
      normal.right -= weight * rows.transpose() * error;
      normal.cost += std::log1p(off);
    }
    return normal;
  }

  Camera moved(Camera camera, const Step& step) const {
    const glm::dvec3 turn(step(0), step(1), step(2)), move(step(3), step(4), step(5));
    const double angle = glm::length(turn);
    const glm::dmat3 axes(camera.world_from_camera), turned = angle > 0 ? axes * glm::mat3_cast(glm::angleAxis(angle, turn / angle)) : axes;
    const glm::dvec3 eye = camera.eye() + axes * (unit_ * move);
    for (int c = 0; c < 3; ++c) camera.world_from_camera[c] = glm::dvec4(turned[c], 0);
    camera.world_from_camera[3] = glm::dvec4(eye, 1);
    camera.lens->scale_x *= std::exp(step(6));
    camera.lens->scale_y *= std::exp(step(7));
    camera.lens->centre_x += step(8);
    camera.lens->centre_y += step(9);
    return camera;
  }

 private:
  /// Of the pixel at which `p`, in camera space, is seen; `error` is how far that is from the sighting.
  Rows derivatives(const glm::dvec3& p, const Lens& lens, const Sighting& s, Eigen::Vector2d& error) const {
    const double depth = orthographic_ ? 1 : -p.z, x = p.x / depth, y = p.y / depth, nearer = orthographic_ ? 0 : 1 / depth;
    error << lens.centre_x + lens.scale_x * x - s.x, lens.centre_y - lens.scale_y * y - s.y;
    const Eigen::RowVector3d across(lens.scale_x / depth, 0, lens.scale_x * x * nearer), down(0, -lens.scale_y / depth, -lens.scale_y * y * nearer);
    Eigen::Matrix3d turn;  // the derivative of p by the turn: p cross
    turn << 0, -p.z, p.y, p.z, 0, -p.x, -p.y, p.x, 0;
    Rows rows = Rows::Zero();
    rows.block<1, 3>(0, 0) = across * turn;
    rows.block<1, 3>(1, 0) = down * turn;
    if (!orthographic_ || fixed_lens_) {  // the lens's centre moves an orthographic camera already
      rows.block<1, 3>(0, 3) = -unit_ * across;
      rows.block<1, 3>(1, 3) = -unit_ * down;
    }
    if (fixed_lens_) return rows;
    rows(0, 6) = lens.scale_x * x;
    rows(1, 7) = -lens.scale_y * y;
    rows(0, 8) = rows(1, 9) = 1;
    return rows;
  }

  const std::vector<Sighting>& sightings_;
  bool orthographic_, fixed_lens_;
  double width_ = 0, unit_ = 1;
};

}  // namespace

void refine(Camera& camera, const std::vector<Sighting>& sightings, bool fixed_lens) {
  if (sightings.empty() || !camera.lens) return;
  const Refiner refiner(camera, sightings, fixed_lens);
  if (!refiner.usable()) return;
  Normal here = refiner.normal_equations(camera);
  double damping = 1e-6;
  constexpr int rounds = 30;  // from a good start 4 or 5 do
  for (int round = 0; round < rounds && damping < 1e6; ++round) {
    auto damped = here.square;
    damped.diagonal() = damped.diagonal() * (1 + damping) + Step::Constant(1e-12 * here.square.diagonal().maxCoeff());  // unknowns left out
    const Step step = damped.ldlt().solve(here.right);
    if (!step.allFinite()) return;
    const Camera next = refiner.moved(camera, step);
    const Normal there = refiner.normal_equations(next);
    const double gain = here.cost - there.cost;
    if (!(gain > 0)) {
      damping *= 10;
      continue;
    }
    camera = next;
    here = there;
    damping *= 0.1;
    if (gain < 1e-9 * here.cost) return;
  }
}

}  // namespace relume
