// Is depth measured along the camera's axis or along the pixel's ray? Against the positions where there are any; else by the planes of the scene,
// whose 1/z is linear over the image.
#include <algorithm>
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

/// Second differences of 1/z along rows, relative to 1/z: rounding is all that is left of them on a plane.
std::optional<Misfit> by_planes(const Asked& asked, const Reading& reading) {
  const Lens& lens = *reading.camera->lens;
  std::vector<double> z, distance;
  for (const SampledBand& band : asked.bands) {
    const int apart = std::max(1, band.window.width() / 64);  // far enough that planes stand out from the depth's rounding
    for (int y = 0; y < band.window.height(); ++y)
      for (int x = apart; x + apart < band.window.width(); ++x) {
        const auto inverse = [&](int at, bool along_ray) {
          const double across = (band.window.min_x + at + 0.5 - lens.centre_x) / lens.scale_x;
          const double up = (lens.centre_y - (band.window.min_y + y + 0.5)) / lens.scale_y;
          const double depth = std::abs(band.value("depth", band.index(at, y)));
          return (along_ray ? std::sqrt(1 + across * across + up * up) : 1) / (depth < reading.background_depth ? depth : 0);
        };
        const auto bend = [&](bool along_ray) {
          return std::abs(inverse(x - apart, along_ray) + inverse(x + apart, along_ray) - 2 * inverse(x, along_ray)) / inverse(x, along_ray);
        };
        if (std::isfinite(bend(false))) z.push_back(bend(false)), distance.push_back(bend(true));
      }
  }
  if (z.size() < 64) return {};
  return Misfit{median(z), median(distance), "of 1/z, bent over what should be planes"};
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
  constexpr double clearly = 1.5;  // times better: half-precision depths blur the difference
  const bool sure = std::max(misfit->z, misfit->distance) > clearly * std::min(misfit->z, misfit->distance);
  if (sure) reading.depth_kind = misfit->z < misfit->distance ? DepthKind::z : DepthKind::distance;
  reading.verdicts.push_back(
      {"depth", reading.depth_kind == DepthKind::z ? "z (along the camera's axis)" : "distance (along the ray)",
       "off by " + three_digits(misfit->z) + " as z, by " + three_digits(misfit->distance) + " as distance (median share " + misfit->measure + ")",
       "--depth-kind", sure});
}

}  // namespace relume
