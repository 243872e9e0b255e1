// A few bands of rows, spread over the frame, of the layers that a question about the file needs: enough to decide by, whatever the frame's size.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <map>
#include <string>
#include <vector>

#include "gbuffer/camera.h"
#include "gbuffer/reading.h"

namespace relume {

struct SampledBand {
  Window window;
  std::map<std::string, std::vector<float>> planes;  ///< by role, components interleaved; absent roles are absent

  bool has(const std::string& role) const { return planes.contains(role); }
  std::int64_t index(int x, int y) const { return std::int64_t(y) * window.width() + x; }
  float value(const std::string& role, std::int64_t i) const { return planes.at(role)[std::size_t(i)]; }
  glm::dvec3 vector(const std::string& role, std::int64_t i) const {
    const float* const v = planes.at(role).data() + 3 * i;
    return {v[0], v[1], v[2]};
  }
};

/// The whole data window if it is small, else bands of 8 rows: about a hundred thousand pixels. Values are as stored.
std::vector<SampledBand> sample_rows(const ExrFile& file, const Reading& reading, const std::vector<std::string>& roles);

/// Pixels whose surface is clear: unmixed, and so are their neighbours. At most a few thousand, with positions as stored.
/// `normals` receives the normals, in the same order; zeros where there is no normal layer.
std::vector<Sighting> clear_sightings(const std::vector<SampledBand>& bands, const Reading& reading, std::vector<glm::dvec3>& normals);

}  // namespace relume
