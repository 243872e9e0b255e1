// Normals from positions.
#include "gbuffer/made_normals.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "gbuffer/layer_frame.h"
#include "gbuffer/layer_values.h"

namespace relume {
namespace {

using glm::dvec3;

constexpr int reach = 2;  // pixels: a difference, and the one behind it to judge it by

bool finite(const dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

struct Positions {
  Window window;
  std::vector<dvec3> at;

  /// NaN outside the window.
  dvec3 get(int x, int y) const {
    if (x < window.min_x || x >= window.max_x || y < window.min_y || y >= window.max_y) return dvec3(std::numeric_limits<double>::quiet_NaN());
    return at[std::size_t(y - window.min_y) * std::size_t(window.width()) + std::size_t(x - window.min_x)];
  }

  /// How the position changes from a pixel to the next in one image direction. A one-sided difference whose continuation bends least is the
  /// likeliest to lie on the pixel's own surface; where both sides continue it alike, the central one is smoother.
  std::optional<dvec3> difference(int x, int y, int dx, int dy) const {
    const dvec3 here = get(x, y), after = get(x + dx, y + dy), before = get(x - dx, y - dy);
    const dvec3 forward = after - here, backward = here - before;
    if (!finite(forward)) return finite(backward) ? std::optional(backward) : std::nullopt;
    if (!finite(backward)) return forward;
    constexpr double smooth = 0.2;  // of the step: what curvature may bend it by within a pixel
    if (glm::length(forward - backward) < smooth * std::min(glm::length(forward), glm::length(backward))) return 0.5 * (forward + backward);
    const auto bend = [&](const dvec3& step, int side) {
      const dvec3 next = get(x + 2 * side * dx, y + 2 * side * dy) - get(x + side * dx, y + side * dy);
      return finite(next) ? glm::length(next * double(side) - step) : glm::length(step);
    };
    return bend(forward, 1) <= bend(backward, -1) ? forward : backward;
  }

  dvec3 normal(int x, int y, const Camera& camera) const {
    const dvec3 here = get(x, y);
    const auto across = difference(x, y, 1, 0), down = difference(x, y, 0, 1);
    if (!finite(here) || !across || !down) return dvec3(0);
    const dvec3 n = glm::cross(*across, *down);
    const double length = glm::length(n);
    if (!(length > 0)) return dvec3(0);
    const dvec3 view = camera.projection == Camera::Projection::orthographic ? camera.backward() : camera.eye() - here;
    return glm::dot(n, view) < 0 ? -n / length : n / length;
  }
};

}  // namespace

std::vector<dvec3> world_positions(const ExrFile& file, const Reading& reading, const Window& window) {
  const LayerFrame frame(reading);
  const dvec3 nothing(std::numeric_limits<double>::quiet_NaN());
  std::vector<dvec3> positions(std::size_t(window.pixels()), nothing);
  std::vector<float> depth, layer;
  if (reading.roles.contains("depth")) depth = layer_values(file, reading.roles.at("depth"), window);
  if (!is_made(reading, "position")) layer = layer_values(file, reading.roles.at("position"), window);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const int x = window.min_x + int(i % std::size_t(window.width())), y = window.min_y + int(i / std::size_t(window.width()));
    if (!depth.empty() && !(std::abs(depth[i]) < reading.background_depth)) continue;
    if (layer.empty()) {
      if (depth[i] != 0) positions[i] = frame.position_from_depth(x, y, depth[i]);
    } else if (const dvec3 p{layer[3 * i], layer[3 * i + 1], layer[3 * i + 2]}; p != dvec3(0)) {
      positions[i] = frame.position_in_world(p);  // exactly the origin is what renderers leave where there is nothing
    }
  }
  return positions;
}

void make_normals(const ExrFile& file, const Reading& reading, const Window& window, const NormalPlanes& to) {
  const Window around = grown(window, reach, reading.data_window);
  const Positions positions{around, world_positions(file, reading, around)};
  tbb::parallel_for(window.min_y, window.max_y, [&](int y) {
    std::size_t out = std::size_t(y - window.min_y) * std::size_t(window.width());
    for (int x = window.min_x; x < window.max_x; ++x, ++out) {
      const dvec3 n = positions.normal(x, y, *reading.camera);
      for (std::size_t c = 0; c < 3; ++c) to.first[c * to.stride + out] = float(n[int(c)]);
    }
  });
}

}  // namespace relume
