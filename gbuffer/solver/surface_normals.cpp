// Geometric normals of sampled pixels.
#include "gbuffer/solver/surface_normals.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <optional>

#include "gbuffer/layer_frame.h"

namespace relume {
namespace {

using glm::dvec3;

/// World positions of one band; NaN where nothing is seen, or only part of the pixel.
class BandPositions {
 public:
  BandPositions(const SampledBand& band, const Reading& reading) : band_(band) {
    const LayerFrame frame(reading);
    const bool made = is_made(reading, "position");
    const RoleLayer& from = reading.roles.at(made ? "depth" : "position");
    precision_ = from.types.front() == SampleType::half_float ? std::ldexp(1.0, -11) : std::ldexp(1.0, -24);
    const Window& w = band.window;
    for (std::int64_t i = 0; i < w.pixels(); ++i) {
      at_.emplace_back(std::numeric_limits<double>::quiet_NaN());
      if (band.has("depth") && !(std::abs(band.value("depth", i)) < reading.background_depth)) continue;
      if (reading.position_premultiplied && band.has("coverage") && band.value("coverage", i) < 0.999f) continue;
      if (!made)
        at_.back() = frame.position_in_world(band.vector("position", i));
      else if (band.value("depth", i) != 0)
        at_.back() = frame.position_from_depth(w.min_x + int(i % w.width()), w.min_y + int(i / w.width()), band.value("depth", i));
    }
  }

  const dvec3& at(int x, int y) const { return at_[std::size_t(band_.index(x, y))]; }

  /// Perpendicular to the differences across and down, if the surface goes on evenly on all four sides. Differences reach as far as it takes to
  /// stand out from the rounding of half-precision positions.
  std::optional<dvec3> normal(int x, int y) const {
    constexpr int farthest = 3;            // rows: a band has 8
    constexpr double above_rounding = 30;  // times a position's rounding: 2 degrees
    for (int k = 1; k <= farthest; ++k) {
      if (x < k || y < k || x + k >= band_.window.width() || y + k >= band_.window.height()) return {};
      const dvec3 here = at(x, y), across = at(x + k, y) - at(x - k, y), down = at(x, y + k) - at(x, y - k);
      const double rounding = above_rounding * precision_ * glm::length(here);
      if (k < farthest && std::min(glm::length(across), glm::length(down)) < rounding) continue;
      constexpr double even = 0.2;  // of the difference: more is an edge
      const dvec3 bend_across = at(x + k, y) + at(x - k, y) - 2.0 * here, bend_down = at(x, y + k) + at(x, y - k) - 2.0 * here;
      if (!(glm::length(bend_across) < even * glm::length(across)) || !(glm::length(bend_down) < even * glm::length(down))) return {};
      const dvec3 n = glm::cross(across, down);
      return glm::length(n) > 0 ? std::optional(glm::normalize(n)) : std::nullopt;
    }
    return {};
  }

 private:
  const SampledBand& band_;
  double precision_;
  std::vector<dvec3> at_;
};

}  // namespace

std::vector<SurfaceNormal> surface_normals(const Asked& asked, const Reading& reading) {
  constexpr std::size_t enough = 4000;
  const Camera& camera = *reading.camera;
  const glm::dmat4 camera_from_world = glm::inverse(camera.world_from_camera);
  const char* const role = reading.roles.contains("base_normal") ? "base_normal" : "normal";
  if (is_made(reading, "position") && !camera.lens) return {};
  std::int64_t pixels = 0;
  for (const SampledBand& band : asked.bands) pixels += band.window.pixels();
  const std::int64_t step = std::max<std::int64_t>(1, pixels / std::int64_t(4 * enough));  // a quarter or more shows even surfaces
  std::vector<SurfaceNormal> samples;
  for (const SampledBand& band : asked.bands) {
    const BandPositions positions(band, reading);
    for (std::int64_t i = step / 2; i < band.window.pixels(); i += step) {
      const dvec3 stored = decoded_normal(reading, band.vector(role, i));
      const double length = glm::length(stored);
      if (!(std::abs(length - 1) < 0.02)) continue;  // a mean of several surfaces is shorter
      const int x = int(i % band.window.width()), y = int(i / band.window.width());
      const auto normal = positions.normal(x, y);
      if (!normal) continue;
      const dvec3 view = camera.projection == Camera::Projection::orthographic ? camera.backward() : camera.eye() - positions.at(x, y);
      const dvec3 facing = glm::dot(*normal, view) < 0 ? -*normal : *normal;
      samples.push_back({facing, stored / length, dvec3(camera_from_world * glm::dvec4(positions.at(x, y), 1))});
    }
  }
  return samples;
}

}  // namespace relume
