// Are positions means over the pixel that count misses as 0? Then only their quotient by coverage lies where the camera sees the pixel.
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "gbuffer/layer_frame.h"
#include "gbuffer/solver/question.h"

namespace relume {
namespace {

/// Pixels from the centre of (x, y) to where the camera sees a point.
double miss(const Camera& camera, const glm::dmat4& camera_from_world, const glm::dvec3& point, double x, double y) {
  const glm::dvec3 seen(camera_from_world * glm::dvec4(point, 1));
  const double depth = camera.projection == Camera::Projection::orthographic ? 1 : -seen.z;
  const Lens& lens = *camera.lens;
  return std::hypot(lens.centre_x + lens.scale_x * seen.x / depth - x - 0.5, lens.centre_y - lens.scale_y * seen.y / depth - y - 0.5);
}

struct Count {
  int as_stored = 0, divided = 0;  ///< pixels in the right place in one reading alone
};

Count count_partial(const Asked& asked, const Reading& reading) {
  const LayerFrame frame(reading);
  const glm::dmat4 camera_from_world = glm::inverse(reading.camera->world_from_camera);
  Count count;
  for (const SampledBand& band : asked.bands) {
    const Window& w = band.window;
    for (std::int64_t i = 0; i < w.pixels(); ++i) {
      const double normal = band.has("normal") ? glm::length(decoded_normal(reading, band.vector("normal", i))) : 1;
      const double coverage = band.has("coverage") ? double(band.value("coverage", i)) : normal;
      constexpr double little = 0.1, nearly_all = 0.9;  // beyond these either reading is near the other, or rounding decides
      const glm::dvec3 stored = band.vector("position", i);
      if (!(coverage > little && coverage < nearly_all) || stored == glm::dvec3(0)) continue;
      const double x = w.min_x + double(i % w.width()), y = w.min_y + double(i / w.width());
      const double plain = miss(*reading.camera, camera_from_world, frame.position_in_world(stored), x, y);
      const double divided = miss(*reading.camera, camera_from_world, frame.position_in_world(stored / coverage), x, y);
      constexpr double near = 1.5, clearly = 0.5;  // pixels: a mean over the pixel and its filter; share of the other's error
      count.as_stored += plain < near && plain < clearly * divided;
      count.divided += divided < near && divided < clearly * plain;
    }
  }
  return count;
}

}  // namespace

void ask_premultiplication(const Asked& asked, Reading& reading) {
  if (asked.options.premultiplied) {
    reading.position_premultiplied = *asked.options.premultiplied;
    reading.colour_premultiplied = reading.colour_premultiplied || reading.position_premultiplied;
    return;
  }
  if (is_made(reading, "position") || !reading.camera || !reading.camera->lens) return;
  const Count count = count_partial(asked, reading);
  constexpr int enough = 16;
  constexpr double most = 0.8;
  const double all = count.as_stored + count.divided;
  if (all < enough) return;
  const bool divided = count.divided > most * all, plain = count.as_stored > most * all;
  if (divided || plain) reading.position_premultiplied = divided;
  if (divided) reading.colour_premultiplied = true;
  reading.verdicts.push_back({"layers", reading.position_premultiplied ? "premultiplied by coverage" : "not premultiplied",
                              "of the pixels that a surface covers in part, " + std::to_string(count.divided) +
                                  " positions are at their pixels only when divided by coverage, " + std::to_string(count.as_stored) +
                                  " only as stored",
                              "--premultiplied", divided || plain});
}

}  // namespace relume
