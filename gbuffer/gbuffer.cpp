// From layers as stored to a band made plain.
#include "gbuffer/gbuffer.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <set>

#include "gbuffer/cryptomatte.h"
#include "gbuffer/edges.h"
#include "gbuffer/error.h"
#include "gbuffer/layer_frame.h"
#include "gbuffer/made_normals.h"
#include "gbuffer/place_sample.h"

namespace relume {
namespace {

using glm::dvec3;

/// Layers that are read but not kept.
struct Loose {
  std::vector<float> depth, tangent, raw_light;
  std::vector<float> float_ids, coverage;
  std::vector<std::uint32_t> ids;
};

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
void add_ids(const ExrFile& file, const Reading& reading, Request& request, Loose& loose, std::size_t pixels) {
  const RoleLayer& layer = layer_of(file, reading, "ids");
  if (layer.types.front() == SampleType::uint32) {
    loose.ids.resize(pixels);
    request.add(layer, 0, loose.ids.data(), sizeof(std::uint32_t), SampleType::uint32);
  } else {
    loose.float_ids.resize(pixels);
    request.add(layer, 0, loose.float_ids.data(), sizeof(float));
  }
}

void settle_ids(const ExrFile& file, const Reading& reading, const Window& window, Loose& loose) {
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

/// Turns one pixel after another into what GBuffer promises.
class Finisher {
 public:
  struct Count {
    std::int64_t surface = 0, bad = 0, partial = 0;
  };

  Finisher(GBuffer& g, const Reading& reading, const Loose& loose)
      : g_(g),
        reading_(reading),
        frame_(reading),
        loose_(loose),
        tangent_ids_(reading.tangent_ids.begin(), reading.tangent_ids.end()),
        bumped_ids_(reading.bumped_ids.begin(), reading.bumped_ids.end()) {}

  Count finish(std::size_t begin, std::size_t end) const {
    Count count;
    for (std::size_t i = begin; i < end; ++i) finish_pixel(i, count);
    return count;
  }

 private:
  dvec3 get(const PlaneRange& range, std::size_t i) const {
    return {g_.planes.plane(range.first)[i], g_.planes.plane(range.first + 1)[i], g_.planes.plane(range.first + 2)[i]};
  }
  void put(const PlaneRange& range, std::size_t i, const dvec3& v) const {
    for (int c = 0; c < 3; ++c) g_.planes.plane(range.first + c)[i] = float(v[c]);
  }
  static bool finite(const dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
  bool concerns(const std::set<std::uint32_t>& ids, std::size_t i) const {
    return ids.empty() || (!loose_.ids.empty() && ids.contains(loose_.ids[i]));
  }

  dvec3 unit_in_world(const dvec3& decoded, const dvec3& position) const {
    constexpr double no_direction = 1e-6;  // less than the smallest half float is rounding, or a filter's tail
    const double length = glm::length(decoded);
    if (!(length > no_direction)) return dvec3(0);
    const dvec3 n = frame_.direction_in_world(decoded / length, position);
    return glm::length(n) > no_direction ? n / glm::length(n) : dvec3(0);  // V-Ray's frame has none straight up
  }

  /// World; infinite where a depth says that nothing is there.
  dvec3 position_at(std::size_t i, double coverage) const {
    const double share = reading_.position_premultiplied ? coverage : 1;
    if (!made_positions_) return frame_.position_in_world(get(g_.position, i) / share);
    const Window& w = g_.window;
    const int x = w.min_x + int(i % std::size_t(w.width())), y = w.min_y + int(i / std::size_t(w.width()));
    return frame_.position_from_depth(x, y, loose_.depth[i] / share);
  }

  bool in_background(std::size_t i) const {
    if (loose_.depth.empty()) return false;
    const float depth = std::abs(loose_.depth[i]);
    return !(depth < reading_.background_depth) || (made_positions_ && depth == 0);
  }

  void finish_pixel(std::size_t i, Count& count) const {
    const double coverage = loose_.coverage.empty() ? 1 : loose_.coverage[i];
    const dvec3 stored = frame_.decoded(get(g_.normal, i));
    const bool far = in_background(i);
    const dvec3 position = far || !(coverage > 0) ? get(g_.position, i) : position_at(i, coverage);
    const bool bad = !finite(stored) || !finite(position);
    count.bad += bad;
    const dvec3 normal = bad || far ? dvec3(0) : unit_in_world(stored, position);
    if (normal == dvec3(0) || !(coverage > 0)) return finish_empty(i);
    put(g_.position, i, position);
    finish_normals(i, normal, position);
    finish_roles(i, reading_.position_premultiplied ? 1 / coverage : 1);
    g_.planes.plane(g_.coverage.first)[i] = float(coverage);
    ++count.surface;
    count.partial += coverage < 1;
  }

  void finish_normals(std::size_t i, const dvec3& normal, const dvec3& position) const {
    const dvec3 base = g_.base_normal.count ? unit_in_world(frame_.decoded(get(g_.base_normal, i)), position) : dvec3(0);
    const bool usable = finite(base) && base != dvec3(0);
    dvec3 shading = normal;
    if (usable && !loose_.tangent.empty() && concerns(tangent_ids_, i)) shading = from_tangent_frame(normal, base, i);
    put(g_.normal, i, shading);
    if (g_.base_normal.count) put(g_.base_normal, i, usable && concerns(bumped_ids_, i) ? base : shading);
  }

  /// n' = s x + t y + n z with s along dp_du made perpendicular to n and t = n x s (research: mitsuba-truth).
  dvec3 from_tangent_frame(const dvec3& local, const dvec3& n, std::size_t i) const {
    const dvec3 dp_du{loose_.tangent[3 * i], loose_.tangent[3 * i + 1], loose_.tangent[3 * i + 2]}, along = dp_du - n * glm::dot(n, dp_du);
    if (!(glm::length(along) > 0)) return n;
    const dvec3 s = glm::normalize(along);
    return glm::normalize(s * local.x + glm::cross(n, s) * local.y + n * local.z);
  }

  void finish_roles(std::size_t i, double factor) const {
    for (const auto& [role, range] : g_.roles) {
      if (role == "coverage" || role.starts_with(cryptomatte_role)) continue;
      const double own = role == "albedo" && made_albedo_ ? std::min(factor, 1.0) : factor;  // a quotient carries no coverage
      for (int c = 0; c < range.count; ++c) {
        float& value = g_.planes.plane(range.first + c)[i];
        value = std::isfinite(value) ? float(value * own) : 0;
      }
    }
  }

  void finish_empty(std::size_t i) const {
    put(g_.position, i, dvec3(0));
    put(g_.normal, i, dvec3(0));
    if (g_.base_normal.count) put(g_.base_normal, i, dvec3(0));
    finish_roles(i, 0);
    g_.planes.plane(g_.coverage.first)[i] = 0;
  }

  GBuffer& g_;
  const Reading& reading_;
  const LayerFrame frame_;
  const Loose& loose_;
  const std::set<std::uint32_t> tangent_ids_, bumped_ids_;
  const bool made_albedo_ = is_made(reading_, "albedo");
  const bool made_positions_ = is_made(reading_, "position");
};

/// A role's planes; where the albedo has to be made they hold the light that it coloured, to be divided by the light itself.
PlaneRange add_role(const ExrFile& file, const Reading& reading, const std::string& role, Request& request, GBuffer& g, Loose& loose) {
  if (!is_made(reading, role)) return add_planes(g, request, layer_of(file, reading, role));
  const RoleLayer& raw = reading.roles.at("diffuse_raw_light");
  loose.raw_light.resize(std::size_t(g.window.pixels()) * 3);
  for (std::size_t c = 0; c < 3; ++c) request.add(raw, c, loose.raw_light.data() + c, 3 * sizeof(float));
  return add_planes(g, request, reading.roles.at("diffuse_light"));
}

void make_albedo(GBuffer& g, const Loose& loose) {
  if (loose.raw_light.empty()) return;
  for (int c = 0; c < 3; ++c) {
    float* const albedo = g.planes.plane(g.roles.at("albedo").first + c);
    for (std::size_t i = 0; i < std::size_t(g.window.pixels()); ++i) {
      const float raw = loose.raw_light[3 * i + std::size_t(c)];
      albedo[i] = raw > 0 ? std::clamp(albedo[i] / raw, 0.0f, 1.0f) : 0.0f;
    }
  }
}

Loose read_layers(const ExrFile& file, const Reading& reading, const std::vector<std::string>& roles, GBuffer& g) {
  Request request{{}, g.window.width()};
  Loose loose;
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
void place(const Mixtures& mixtures, const Reading& reading, GBuffer& g, Loose& loose) {
  if (mixtures.samples.empty()) return;
  loose.coverage.resize(std::size_t(g.samples()), 1.0f);
  if (!loose.ids.empty()) loose.ids.resize(std::size_t(g.samples()));
  std::size_t extra = std::size_t(g.window.pixels());
  for (std::size_t k = 0; k < mixtures.samples.size(); ++k) {
    const Mixtures::Sample& sample = mixtures.samples[k];
    const std::size_t home = std::size_t(sample.pixel), at = mixtures.first_of_pixel(k) ? home : extra++;
    for (const auto& [role, range] : g.roles)  // what a mixture does not tell apart (a Cryptomatte's ids, a made albedo) stays the pixel's
      for (int c = 0; c < range.count; ++c) g.planes.plane(range.first + c)[at] = g.planes.plane(range.first + c)[home];
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
  Loose loose = read_layers(file, reading, roles, g);
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
