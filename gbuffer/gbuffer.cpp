// From layers as stored to a band made plain.
#include "gbuffer/gbuffer.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>

#include "gbuffer/cryptomatte.h"
#include "gbuffer/edges.h"
#include "gbuffer/error.h"
#include "gbuffer/finisher.h"
#include "gbuffer/made_normals.h"
#include "gbuffer/place_sample.h"

namespace relume {
namespace {

struct Request {
  std::map<int, std::vector<Destination>> by_part;
  int width = 0;

  void add(const RoleLayer& layer, std::size_t component, void* to, std::size_t step, SampleType type = SampleType::float32) {
    by_part[layer.part].push_back({layer.channels[component], type, to, step, step * std::size_t(width)});
  }
  void read(const ExrFile& file, const Window& window) const {
    for (const auto& [part, destinations] : by_part) file.read(part, window, destinations);
  }
};

PlaneRange add_planes(GBuffer& g, Request& request, const RoleLayer& layer) {
  const int count = int(layer.channels.size());
  const PlaneRange range{g.planes.add(count), count};
  for (int c = 0; c < count; ++c) request.add(layer, std::size_t(c), g.planes.plane(range.first + c), sizeof(float));
  return range;
}

const RoleLayer& layer_of(const ExrFile& file, const Reading& reading, const std::string& role) {
  const auto found = reading.roles.find(role);
  if (found == reading.roles.end())
    throw Error(ErrorKind::input, file.path().string() + ": no layer for " + role + " (--map " + role + "=LAYER names one)");
  return found->second;
}

bool has(const Reading& reading, const std::string& role) { return reading.roles.contains(role); }

/// Ids are wanted by the caller or by rules that hold for some objects only.
bool ids_needed(const Reading& reading, const std::vector<std::string>& roles) {
  return std::find(roles.begin(), roles.end(), "ids") != roles.end() ||
         (has(reading, "ids") && !(reading.tangent_ids.empty() && reading.bumped_ids.empty()));
}

/// Whole numbers stay exact; means over a filter are mended.
void add_ids(const ExrFile& file, const Reading& reading, Request& request, LooseLayers& loose, std::size_t pixels) {
  const RoleLayer& layer = layer_of(file, reading, "ids");
  if (layer.types.front() == SampleType::uint32) {
    loose.ids.resize(pixels);
    request.add(layer, 0, loose.ids.data(), sizeof(std::uint32_t), SampleType::uint32);
  } else {
    loose.float_ids.resize(pixels);
    request.add(layer, 0, loose.float_ids.data(), sizeof(float));
  }
}

void settle_ids(const ExrFile& file, const Reading& reading, const Window& window, LooseLayers& loose) {
  if (loose.float_ids.empty() || !loose.ids.empty()) return;
  const auto whole = [](float id) { return id >= 0 && id < 4294967040.0f && id == std::floor(id); };
  if (!std::all_of(loose.float_ids.begin(), loose.float_ids.end(), whole)) {
    Edges edges = mend_edges(file, reading, window);
    loose.ids = std::move(edges.ids);
    if (loose.coverage.empty())  // what a filter's tail leaks into has no id
      for (const float coverage : edges.coverage) loose.coverage.push_back(coverage > 0 ? 1.0f : 0.0f);
    return;
  }
  loose.ids.assign(loose.float_ids.begin(), loose.float_ids.end());
}

/// A role's planes; where the albedo has to be made they hold the light that it coloured, to be divided by the light itself.
PlaneRange add_role(const ExrFile& file, const Reading& reading, const std::string& role, Request& request, GBuffer& g, LooseLayers& loose) {
  if (!is_made(reading, role)) return add_planes(g, request, layer_of(file, reading, role));
  const RoleLayer& raw = reading.roles.at("diffuse_raw_light");
  loose.raw_light.resize(std::size_t(g.window.pixels()) * 3);
  for (std::size_t c = 0; c < 3; ++c) request.add(raw, c, loose.raw_light.data() + c, 3 * sizeof(float));
  return add_planes(g, request, reading.roles.at("diffuse_light"));
}

void make_albedo(GBuffer& g, const LooseLayers& loose) {
  if (loose.raw_light.empty()) return;
  for (int c = 0; c < 3; ++c) {
    float* const albedo = g.planes.plane(g.roles.at("albedo").first + c);
    for (std::size_t i = 0; i < std::size_t(g.window.pixels()); ++i) {
      const float raw = loose.raw_light[3 * i + std::size_t(c)];
      albedo[i] = raw > 0 ? std::clamp(albedo[i] / raw, 0.0f, 1.0f) : 0.0f;
    }
  }
}

LooseLayers read_layers(const ExrFile& file, const Reading& reading, const std::vector<std::string>& roles, GBuffer& g) {
  Request request{{}, g.window.width()};
  LooseLayers loose;
  g.position = is_made(reading, "position") ? PlaneRange{g.planes.add(3), 3} : add_planes(g, request, layer_of(file, reading, "position"));
  g.normal = is_made(reading, "normal") ? PlaneRange{g.planes.add(3), 3} : add_planes(g, request, layer_of(file, reading, "normal"));
  if (has(reading, "base_normal")) g.base_normal = add_planes(g, request, reading.roles.at("base_normal"));
  g.coverage = {g.planes.add(1), 1};
  for (const std::string& role : roles)
    if (role != "ids" && !g.roles.contains(role)) g.roles[role] = add_role(file, reading, role, request, g, loose);
  if (has(reading, "depth")) {
    loose.depth.resize(std::size_t(g.samples()));
    request.add(reading.roles.at("depth"), 0, loose.depth.data(), sizeof(float));
  }
  if (reading.normal_in_tangent_frame && has(reading, "tangent")) {
    loose.tangent.resize(std::size_t(g.samples()) * 3);
    for (std::size_t c = 0; c < 3; ++c) request.add(reading.roles.at("tangent"), c, loose.tangent.data() + c, 3 * sizeof(float));
  }
  if (ids_needed(reading, roles)) add_ids(file, reading, request, loose, std::size_t(g.samples()));
  request.read(file, g.window);
  make_albedo(g, loose);
  if (is_made(reading, "normal")) make_normals(file, reading, g.window, {g.planes.plane(g.normal.first), g.planes.stride()});
  if (reading.position_premultiplied) {
    Edges edges = mend_edges(file, reading, g.window);
    loose.coverage = std::move(edges.coverage);
    if (loose.ids.empty()) loose.ids = std::move(edges.ids);  // whole numbers in the file need no mending
  }
  settle_ids(file, reading, g.window, loose);
  return loose;
}

/// Mixed pixels are replaced by their first surface; the others follow after all pixels.
void place(const Mixtures& mixtures, const Reading& reading, GBuffer& g, LooseLayers& loose) {
  if (mixtures.samples.empty()) return;
  loose.coverage.resize(std::size_t(g.samples()), 1.0f);
  if (!loose.ids.empty()) loose.ids.resize(std::size_t(g.samples()));
  std::size_t extra = std::size_t(g.window.pixels());
  for (std::size_t k = 0; k < mixtures.samples.size(); ++k) {
    const Mixtures::Sample& sample = mixtures.samples[k];
    const std::size_t home = std::size_t(sample.pixel), at = mixtures.first_of_pixel(k) ? home : extra++;
    for (const auto& [role, range] : g.roles)  // what a mixture does not tell apart (a Cryptomatte's ids, a made albedo) stays the pixel's
      for (int c = 0; c < range.count && role != "coverage"; ++c)  // the stored alpha is the whole pixel's, and counts once
        g.planes.plane(range.first + c)[at] = g.planes.plane(range.first + c)[home];
    place_sample(mixtures, k, at, reading, g);
    loose.coverage[at] = sample.coverage;
    if (!loose.ids.empty()) loose.ids[at] = sample.id;
    if (!loose.depth.empty()) loose.depth[at] = 0;  // the pixel's centre may show the background
    for (std::size_t c = 0; c < 3 && !loose.tangent.empty(); ++c) loose.tangent[3 * at + c] = loose.tangent[3 * home + c];
  }
}

int planes_needed(const ExrFile& file, const Reading& reading, const std::vector<std::string>& roles) {
  int count = 3 + 3 + 3 + 1;
  for (const std::string& role : roles) count += is_made(reading, role) ? 3 : int(layer_of(file, reading, role).channels.size());
  return count;
}

}  // namespace

GBuffer read_gbuffer(const ExrFile& file, const Reading& reading, const Window& window, const std::vector<std::string>& roles, int spare_planes,
                     const Mixtures& mixtures) {
  const std::size_t samples = std::size_t(window.pixels() + mixtures.extras());
  GBuffer g{window, Planes(samples, planes_needed(file, reading, roles) + spare_planes), {}, {}, {}, {}, false, {}, {}, 0, 0, homes_of(mixtures)};
  LooseLayers loose = read_layers(file, reading, roles, g);
  place(mixtures, reading, g, loose);
  const Finisher finisher(g, reading, loose);
  constexpr std::size_t grain = 1 << 14;  // pixels: a third of a millisecond of work
  const Finisher::Count count = tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, samples, grain), Finisher::Count{},
      [&](const auto& range, const Finisher::Count& before) {
        const Finisher::Count here = finisher.finish(range.begin(), range.end());
        return Finisher::Count{before.surface + here.surface, before.bad + here.bad, before.partial + here.partial};
      },
      [](const Finisher::Count& a, const Finisher::Count& b) {
        return Finisher::Count{a.surface + b.surface, a.bad + b.bad, a.partial + b.partial};
      });
  g.surface_pixels = count.surface - std::int64_t(g.homes.size());
  g.bad_pixels = count.bad;
  g.fractional_coverage = count.partial > 0;
  if (std::find(roles.begin(), roles.end(), "ids") != roles.end()) g.ids = std::move(loose.ids);
  return g;
}

}  // namespace relume
