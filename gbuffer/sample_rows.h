// A few bands of rows, spread over the frame, of the layers that a question about the file needs: enough to decide by, whatever the frame's size.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "gbuffer/camera.h"
#include "gbuffer/reading.h"

namespace relume {

struct SampledBand {
  Window window;
  std::map<std::string, std::vector<float>, std::less<>> planes;  ///< by role, components interleaved; absent roles are absent

  bool has(std::string_view role) const { return planes.contains(role); }
  std::int64_t index(int x, int y) const { return std::int64_t(y) * window.width() + x; }
  const std::vector<float>& plane(std::string_view role) const {
    const auto found = planes.find(role);
    if (found == planes.end()) throw std::out_of_range("no samples of this role");
    return found->second;
  }
  float value(std::string_view role, std::int64_t i) const { return plane(role)[std::size_t(i)]; }
  glm::dvec3 vector(std::string_view role, std::int64_t i) const {
    const float* const v = plane(role).data() + 3 * i;
    return {v[0], v[1], v[2]};
  }
};

/// The whole data window if it is small, else bands of 8 rows: about a hundred thousand pixels. Values are as stored.
std::vector<SampledBand> sample_rows(const ExrFile& file, const Reading& reading, const std::vector<std::string>& roles);

/// Pixels whose surface is clear: unmixed, and so are their neighbours. At most a few thousand, with positions as stored.
/// `normals` receives the normals, in the same order; zeros where there is no normal layer.
std::vector<Sighting> clear_sightings(const std::vector<SampledBand>& bands, const Reading& reading, std::vector<glm::dvec3>& normals);

}  // namespace relume
