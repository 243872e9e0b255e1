// Sampling a frame to decide how to read it.
#include "gbuffer/sample_rows.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace relume {
namespace {

std::vector<Window> bands_of(const Window& data) {
  constexpr std::int64_t budget = 1 << 20;
  constexpr int rows = 8;  // neighbours above and below, and half of a zip block
  if (data.pixels() <= budget) return {data};
  const int count = int(std::clamp<std::int64_t>(budget / rows / data.width(), 4, data.height() / rows));
  std::vector<Window> bands;
  for (int i = 0; i < count; ++i) {
    const int top = data.min_y + int((std::int64_t(data.height()) - rows) * (2 * i + 1) / (2 * count));
    bands.push_back({data.min_x, top, data.max_x, top + rows});
  }
  return bands;
}

bool surface(const SampledBand& band, const Reading& reading, std::int64_t i) {
  const glm::dvec3 p = band.vector("position", i), n = decoded_normal(reading, band.vector("normal", i));
  const auto finite = [](const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); };
  if (!finite(p) || !finite(n) || glm::dot(n, n) == 0) return false;
  return !band.has("depth") || std::abs(band.value("depth", i)) < reading.background_depth;
}

/// A mean of several surfaces' normals is short: 0.99 lets curvature within the pixel through.
bool clear(const SampledBand& band, const Reading& reading, std::int64_t i) {
  if (!surface(band, reading, i)) return false;
  if (reading.position_premultiplied && band.has("coverage") && band.value("coverage", i) < 0.999f) return false;
  return std::abs(glm::length(decoded_normal(reading, band.vector("normal", i))) - 1) < 0.01;
}

template <class Accept>
std::vector<std::pair<const SampledBand*, std::int64_t>> accepted(const std::vector<SampledBand>& bands, Accept&& accept) {
  std::vector<std::pair<const SampledBand*, std::int64_t>> pixels;
  for (const SampledBand& band : bands)
    for (int y = 0; y < band.window.height(); ++y)
      for (int x = 0; x < band.window.width(); ++x)
        if (accept(band, x, y)) pixels.emplace_back(&band, band.index(x, y));
  return pixels;
}

}  // namespace

std::vector<SampledBand> sample_rows(const ExrFile& file, const Reading& reading, const std::vector<std::string>& roles) {
  std::vector<SampledBand> bands;
  for (const Window& window : bands_of(reading.data_window)) {
    SampledBand band{window, {}};
    std::map<int, std::vector<Destination>> by_part;
    for (const std::string& role : roles) {
      const auto found = reading.roles.find(role);
      if (found == reading.roles.end()) continue;
      const std::vector<std::string>& channels = found->second.channels;
      std::vector<float>& plane = band.planes[role];
      plane.resize(std::size_t(window.pixels()) * channels.size());
      const std::size_t step = channels.size() * sizeof(float);
      for (std::size_t c = 0; c < channels.size(); ++c)
        by_part[found->second.part].push_back({channels[c], SampleType::float32, plane.data() + c, step, step * std::size_t(window.width())});
    }
    for (const auto& [part, destinations] : by_part) file.read(part, window, destinations);
    bands.push_back(std::move(band));
  }
  return bands;
}

glm::dvec3 decoded_normal(const Reading& reading, const glm::dvec3& stored) {
  if (reading.normal_encoding == NormalEncoding::as_signed || stored == glm::dvec3(0)) return stored;
  return 2.0 * stored - 1.0;
}

std::vector<Sighting> clear_sightings(const std::vector<SampledBand>& bands, const Reading& reading, std::vector<glm::dvec3>& normals) {
  constexpr std::size_t enough = 3000, too_few = 64;
  auto pixels = accepted(bands, [&](const SampledBand& band, int x, int y) {
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, band.window.height() - 1); ++v)
      for (int u = std::max(x - 1, 0); u <= std::min(x + 1, band.window.width() - 1); ++u)
        if (!clear(band, reading, band.index(u, v))) return false;
    return true;
  });
  if (pixels.size() < too_few)  // thin objects only, or normals of any length: then the fit has to stand the worse ones
    pixels = accepted(bands, [&](const SampledBand& band, int x, int y) { return surface(band, reading, band.index(x, y)); });
  const std::size_t step = std::max<std::size_t>(1, pixels.size() / enough);
  std::vector<Sighting> sightings;
  normals.clear();
  for (std::size_t k = 0; k < pixels.size(); k += step) {
    const auto [band, i] = pixels[k];
    const double x = band->window.min_x + double(i % band->window.width()), y = band->window.min_y + double(i / band->window.width());
    sightings.push_back({x + 0.5, y + 0.5, band->vector("position", i)});
    normals.push_back(decoded_normal(reading, band->vector("normal", i)));
  }
  return sightings;
}

}  // namespace relume
