// Is depth measured along the camera's axis or along the pixel's ray? Against the positions where there are any; else by the planes of the scene,
// whose 1/z is linear over the image.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "gbuffer/layer_frame.h"
#include "gbuffer/median.h"
#include "gbuffer/solver/question.h"
#include "gbuffer/three_digits.h"

namespace relume {
namespace {

/// How badly each reading explains the depth; the less the better.
struct Misfit {
  double z, distance;
  std::string measure;
  double inverse = std::numeric_limits<double>::infinity();  ///< as 1/z or 1/distance
};

std::optional<Misfit> against_positions(const Asked& asked, const Reading& reading) {
  const LayerFrame frame(reading);
  const glm::dmat4 camera_from_world = glm::inverse(reading.camera->world_from_camera);
  std::vector<double> z, distance;
  for (const SampledBand& band : asked.bands)
    for (std::int64_t i = 0; i < band.window.pixels(); ++i) {
      const glm::dvec3 stored = band.vector("position", i);
      const double depth = std::abs(band.value("depth", i));
      if (stored == glm::dvec3(0) || !(depth > 0) || !(depth < reading.background_depth)) continue;
      const glm::dvec3 seen(camera_from_world * glm::dvec4(frame.position_in_world(stored), 1));
      if (!(std::abs(seen.z) > 0)) continue;
      z.push_back(std::abs(-seen.z / depth - 1));
      distance.push_back(std::abs(glm::length(seen) / depth - 1));
    }
  if (z.size() < 64) return {};
  return Misfit{median(z), median(distance), "of the depth, from the positions"};
}

/// What is linear over the image of a plane where depth is z, distance, 1/z or 1/distance. `ray`: the distance of z = 1 along the pixel's ray.
std::array<double, 4> linear_on_planes(double depth, double ray) { return {1 / depth, ray / depth, depth, depth * ray}; }

/// Second differences of 1/z along rows, relative to 1/z: rounding is all that is left of them on a plane.
std::optional<Misfit> by_planes(const Asked& asked, const Reading& reading) {
  const Lens& lens = *reading.camera->lens;
  std::array<std::vector<double>, 4> bends;
  for (const SampledBand& band : asked.bands) {
    const int apart = std::max(1, band.window.width() / 64);  // far enough that planes stand out from the depth's rounding
    for (int y = 0; y < band.window.height(); ++y)
      for (int x = apart; x + apart < band.window.width(); ++x) {
        const auto linear = [&](int at) {
          const double across = (band.window.min_x + at + 0.5 - lens.centre_x) / lens.scale_x;
          const double up = (lens.centre_y - (band.window.min_y + y + 0.5)) / lens.scale_y;
          const double depth = std::abs(band.value("depth", band.index(at, y)));
          return linear_on_planes(depth < reading.background_depth ? depth : 0, std::sqrt(1 + across * across + up * up));
        };
        const auto left = linear(x - apart), here = linear(x), right = linear(x + apart);
        if (!std::isfinite(left[0] + here[0] + right[0])) continue;
        for (std::size_t k = 0; k < bends.size(); ++k) bends[k].push_back(std::abs(left[k] + right[k] - 2 * here[k]) / here[k]);
      }
  }
  if (bends[0].size() < 64) return {};
  return Misfit{median(bends[0]), median(bends[1]), "of 1/z, bent over what should be planes", std::min(median(bends[2]), median(bends[3]))};
}

/// Disparity, or a depth buffer: nothing says between which planes it is scaled, so no position can be made of it.
void note_inverse_depth(const Misfit& misfit, Reading& reading) {
  constexpr double clearly = 10;  // times better: on tilted planes it is hundreds, on curved surfaces and on walls that face the camera 1 to 2
  if (clearly * misfit.inverse < std::min(misfit.z, misfit.distance))
    reading.notes.push_back("warning: depth is linear over planes as 1/z would be, not z: positions made from it are then wrong (" +
                            reading.roles.at("depth").layer + "; --map position=LAYER or --map depth=LAYER names another)");
}

/// A depth that fills 0..1 is likelier to be scaled for looking at than to be that of a scene less than one unit deep.
void note_scaled_depth(const Asked& asked, Reading& reading) {
  float nearest = std::numeric_limits<float>::infinity(), farthest = 0;
  for (const SampledBand& band : asked.bands)
    for (const float depth : band.planes.at("depth"))
      if (depth > 0 && depth < reading.background_depth) nearest = std::min(nearest, depth), farthest = std::max(farthest, depth);
  constexpr float spread = 0.25;  // of the unit: a small object seen from less than one unit away is not as deep
  if (farthest <= 1 && farthest - nearest > spread)
    reading.notes.push_back("warning: depth lies within 0..1, as if scaled between a near and a far plane: positions made from it are then wrong (" +
                            reading.roles.at("depth").layer + "; --map position=LAYER or --map depth=LAYER names another)");
}

}  // namespace

void ask_depth_kind(const Asked& asked, Reading& reading) {
  if (!reading.roles.contains("depth")) return;
  if (is_made(reading, "position")) note_scaled_depth(asked, reading);
  if (asked.options.depth_kind || !reading.camera) return;
  if (reading.camera->projection == Camera::Projection::orthographic) return;  // there both are the same
  const bool made = is_made(reading, "position");
  if (made && !reading.camera->lens) return;
  const auto misfit = made ? by_planes(asked, reading) : against_positions(asked, reading);
  if (!misfit) return;
  if (made) note_inverse_depth(*misfit, reading);
  constexpr double clearly = 1.5;  // times better: half-precision depths blur the difference
  const bool sure = std::max(misfit->z, misfit->distance) > clearly * std::min(misfit->z, misfit->distance);
  if (sure) reading.depth_kind = misfit->z < misfit->distance ? DepthKind::z : DepthKind::distance;
  reading.verdicts.push_back(
      {"depth", reading.depth_kind == DepthKind::z ? "z (along the camera's axis)" : "distance (along the ray)",
       "off by " + three_digits(misfit->z) + " as z, by " + three_digits(misfit->distance) + " as distance (median share " + misfit->measure + ")",
       "--depth-kind", sure});
}

}  // namespace relume
