// From a surface's values to stored ones: encoded, and premultiplied where the file's are.
#include "gbuffer/place_sample.h"

namespace relume {
namespace {

/// Where a role's stored values lie; nothing where they are not kept.
PlaneRange range_of(const GBuffer& g, const std::string& role) {
  if (role == "position") return g.position;
  if (role == "normal") return g.normal;
  if (role == "base_normal") return g.base_normal;
  const auto found = g.roles.find(role);
  return found == g.roles.end() || role == "coverage" ? PlaneRange{} : found->second;
}

}  // namespace

void place_sample(const Mixtures& mixtures, std::size_t sample, std::size_t at, const Reading& reading, GBuffer& gbuffer) {
  const float* const values = mixtures.values.data() + sample * std::size_t(mixtures.components);
  for (std::size_t r = 0; r < mixtures.roles.size(); ++r) {
    const std::string& role = mixtures.roles[r];
    const PlaneRange range = range_of(gbuffer, role);
    for (int c = 0; c < range.count; ++c) {
      const float value = values[mixtures.firsts[r] + c];
      float& stored = gbuffer.planes.plane(range.first + c)[at];
      if (role == "normal" || role == "base_normal")
        stored = reading.normal_encoding == NormalEncoding::as_signed ? value : (value + 1) / 2;
      else
        stored = reading.position_premultiplied ? value * mixtures.samples[sample].coverage : value;
    }
  }
}

std::vector<std::int64_t> homes_of(const Mixtures& mixtures) {
  std::vector<std::int64_t> homes;
  for (std::size_t k = 0; k < mixtures.samples.size(); ++k)
    if (!mixtures.first_of_pixel(k)) homes.push_back(mixtures.samples[k].pixel);
  return homes;
}

}  // namespace relume
