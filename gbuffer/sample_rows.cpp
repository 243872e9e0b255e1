// Sampling a frame to decide how to read it.
#include "gbuffer/sample_rows.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "gbuffer/layer_frame.h"

namespace relume {
namespace {

std::vector<Window> bands_of(const Window& data) {
  constexpr std::int64_t budget = 1 << 17;  // pixels; a hundredth of a second to decode and judge
  if (data.pixels() <= budget) return {data};
  const int rows = std::min(8, data.height());                                   // neighbours above and below, and half of a zip block
  const int columns = int(std::min<std::int64_t>(budget / rows, data.width()));  // a frame a million wide has rows too long to hold
  const int most = data.height() / rows * (data.width() / columns), wanted = int(std::min<std::int64_t>(budget / rows / columns, most));
  const int count = std::clamp(wanted, std::min(4, most), most);
  std::vector<Window> bands;
  for (int i = 0; i < count; ++i) {
    const std::int64_t about = (std::int64_t(data.height()) - rows) * (2 * i + 1) / (2 * count);
    const int top = data.min_y + int(about - about % rows);  // within one block of the codec: a second would cost as much again
    const int left = data.min_x + int((std::int64_t(data.width()) - columns) * (2 * i + 1) / (2 * count));
    bands.push_back({left, top, left + columns, top + rows});
  }
  return bands;
}

/// What each pixel of a band shows: looked up often, so found once.
struct Clarity {
  std::vector<char> surface;  ///< finite position and normal, in front of the background
  std::vector<char> clear;    ///< and unmixed: a mean of several surfaces' normals is short; 0.01 lets curvature within the pixel through
};

Clarity clarity_of(const SampledBand& band, const Reading& reading) {
  const auto plane = [&](const char* role) { return band.has(role) ? band.planes.at(role).data() : nullptr; };
  const float *const position = plane("position"), *const normal = plane("normal"), *const depth = plane("depth"),
                     *const coverage = plane("coverage");
  const std::size_t pixels = std::size_t(band.window.pixels());
  Clarity clarity{std::vector<char>(pixels), std::vector<char>(pixels)};
  if (!position) return clarity;
  for (std::size_t i = 0; i < pixels; ++i) {
    const float* p = position + 3 * i;
    const glm::dvec3 n = normal ? decoded_normal(reading, {normal[3 * i], normal[3 * i + 1], normal[3 * i + 2]}) : glm::dvec3(p[0], p[1], p[2]);
    const double length = glm::length(n);
    if (!std::isfinite(p[0] + p[1] + p[2]) || !std::isfinite(length) || length == 0) continue;
    if (depth && !(std::abs(depth[i]) < reading.background_depth)) continue;
    clarity.surface[i] = 1;
    clarity.clear[i] = (!normal || std::abs(length - 1) < 0.01) && !(reading.position_premultiplied && coverage && coverage[i] < 0.999f);
  }
  return clarity;
}

using Pixels = std::vector<std::pair<const SampledBand*, std::int64_t>>;

/// Adds the pixels of a band that are clear, as are their neighbours; or, with `any`, all that show a surface.
void accept(const SampledBand& band, const Clarity& clarity, bool any, Pixels& pixels) {
  const int width = band.window.width(), height = band.window.height();
  const auto clear_around = [&](int x, int y) {
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height - 1); ++v)
      for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u)
        if (!clarity.clear[std::size_t(band.index(u, v))]) return false;
    return true;
  };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (any ? clarity.surface[std::size_t(band.index(x, y))] != 0 : clear_around(x, y)) pixels.emplace_back(&band, band.index(x, y));
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

std::vector<Sighting> clear_sightings(const std::vector<SampledBand>& bands, const Reading& reading, std::vector<glm::dvec3>& normals) {
  constexpr std::size_t enough = 3000, too_few = 64;
  Pixels pixels;
  for (const bool any : {false, true})  // thin objects only, or normals of any length: then the fit has to stand the worse pixels
    if (pixels.size() < too_few) {
      pixels.clear();
      for (const SampledBand& band : bands) accept(band, clarity_of(band, reading), any, pixels);
    }
  const std::size_t step = std::max<std::size_t>(1, pixels.size() / enough);
  std::vector<Sighting> sightings;
  normals.clear();
  for (std::size_t k = 0; k < pixels.size(); k += step) {
    const auto [band, i] = pixels[k];
    const double x = band->window.min_x + double(i % band->window.width()), y = band->window.min_y + double(i / band->window.width());
    sightings.push_back({x + 0.5, y + 0.5, band->vector("position", i)});
    normals.push_back(band->has("normal") ? decoded_normal(reading, band->vector("normal", i)) : glm::dvec3(0));
  }
  return sightings;
}

}  // namespace relume
