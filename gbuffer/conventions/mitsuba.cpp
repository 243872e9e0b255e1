// Mitsuba 3's `aov` integrator: layers bear the scene author's names, their suffixes tell the type (research: mitsuba-truth, exr-conventions A.3).
#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

#include "gbuffer/conventions/mitsuba_bump.h"
#include "gbuffer/layer_frame.h"
#include "gbuffer/reading.h"
#include "gbuffer/role_layers.h"
#include "gbuffer/samples.h"

namespace relume {
namespace {

std::string recognise(const ExrFile& file, const std::vector<Layer>& layers) {
  const Imf::Header& header = file.parts().front().header;
  if (matrix_attribute(header, "worldToCamera")) return {};
  const auto depth = std::find_if(layers.begin(), layers.end(), [](const Layer& l) { return l.component('t') && l.components.size() == 1; });
  const bool vectors =
      std::any_of(layers.begin(), layers.end(), [](const Layer& l) { return l.component('x') && l.component('y') && l.component('z'); });
  return depth != layers.end() && vectors ? "channel \"" + depth->components.front().channel + "\" beside vectors, and no camera" : "";
}

using Test = std::function<bool(const std::string& normalised_name)>;

bool holds(const std::string& name, const char* part) { return name.find(part) != std::string::npos; }

/// The first layer with these components whose name passes; names are the author's, so likeness has to do.
void assign_like(const std::vector<Layer>& layers, Reading& reading, const std::string& role, const std::string& letters, const Test& test) {
  if (reading.roles.contains(role)) return;
  for (const Layer& layer : layers) {
    const bool typed = std::all_of(letters.begin(), letters.end(), [&](char c) { return layer.component(c); });
    if (!typed || !test(normalised(layer.name))) continue;
    reading.roles[role] = as_role(layer, role);
    return;
  }
}

void assign_typed(const ExrFile&, const std::vector<Layer>& layers, Reading& reading) {
  const auto geometric = [](const std::string& n) { return holds(n, "geo") || n == "ng" || n == "gn"; };
  assign_like(layers, reading, "position", "xyz", [](const std::string& n) { return holds(n, "pos"); });
  assign_like(layers, reading, "normal", "xyz", [&](const std::string& n) { return holds(n, "norm") && !geometric(n); });
  assign_like(layers, reading, "base_normal", "xyz", geometric);
  // A scene that stores one kind of normal only stores the geometric one seldom, but then it is the best there is.
  if (!reading.roles.contains("normal") && reading.roles.contains("base_normal")) reading.roles["normal"] = reading.roles["base_normal"];
  assign_like(layers, reading, "tangent", "xyz", [](const std::string& n) { return holds(n, "dpdu"); });
  assign_like(layers, reading, "depth", "t", [](const std::string&) { return true; });
  assign_like(layers, reading, "albedo", "rgb", [](const std::string& n) { return holds(n, "albedo"); });
  assign_like(layers, reading, "uv", "uv", [](const std::string& n) { return !holds(n, "duv"); });
  assign_like(layers, reading, "ids", "i", [](const std::string& n) { return holds(n, "shape"); });
  assign_like(layers, reading, "ids", "i", [](const std::string& n) { return !holds(n, "prim"); });
  assign_like(layers, reading, "primitive_ids", "i", [](const std::string& n) { return holds(n, "prim"); });
  reading.position_premultiplied = true;
}

/// Alpha is in a nested integrator's image or beside R G B; an `aov` integrator alone writes zeros there, which say nothing.
void find_coverage(Samples& samples, const ReadingOptions& options, Reading& reading) {
  if (options.map.contains("coverage")) return;
  auto layers = layers_of(samples.file());
  std::stable_partition(layers.begin(), layers.end(), [](const Layer& layer) { return !layer.name.empty(); });
  for (const Layer& layer : layers) {
    if (!layer.component('a') || !layer.component('r')) continue;
    reading.roles["coverage"] = as_role(layer, "coverage");
    for (const SampledBand& band : samples.bands(reading))
      for (const float value : band.planes.at("coverage"))
        if (value != 0) return;
  }
  reading.roles.erase("coverage");
}

/// Whether pixels are means over several samples: fractions of ids, and normals shorter than 1, only come from averaging.
void settle_filtering(Samples& samples, const ReadingOptions& options, Reading& reading) {
  find_coverage(samples, options, reading);
  std::int64_t mixed = 0, all = 0;
  for (const SampledBand& band : samples.bands(reading)) {
    for (std::int64_t i = 0; i < band.window.pixels(); ++i) {
      const double length = band.has("normal") ? glm::length(decoded_normal(reading, band.vector("normal", i))) : 1;
      if (!(length > 0)) continue;
      const double id = band.has("ids") ? double(band.value("ids", i)) : 0;
      constexpr double short_of_one = 0.98, fraction = 0.01;  // wider than what half precision rounds
      mixed += length < short_of_one || std::abs(id - std::round(id)) > fraction;
      ++all;
    }
  }
  if (mixed > 0) {
    const bool stored = reading.roles.contains("coverage");
    reading.notes.push_back(
        "anti-aliased layers: " + std::to_string(mixed) + " of " + std::to_string(all) +
        " pixels looked at mix surfaces; layers are divided by the coverage " +
        (stored ? "in " + reading.roles.at("coverage").channels.front() : std::string("estimated from ids and normals, since no alpha was written")));
    return;
  }
  reading.position_premultiplied = reading.colour_premultiplied = false;
}

}  // namespace

extern const Convention convention_mitsuba;
const Convention convention_mitsuba{
    .name = "mitsuba",
    .title = "Mitsuba 3, aov integrator",
    .source = "Mitsuba 3.9.1, measured; src/integrators/aov.cpp",
    .marks = {{.attribute = "generatedBy", .text = "mitsuba"}},
    .aliases = {{"position", {"position", "pos", "P"}}, {"normal", {"sh_normal", "nn", "normal", "normals", "ns", "sn", "n"}}},
    .takes_common_names = false,
    .facing = Facing::one_sided,
    .colour_premultiplied = true,
    .recognise = recognise,
    .recognised_by = "a depth channel .T beside vectors, and no camera in the header",
    .assign = assign_typed,
    .settle_space = settle_filtering,
    .settle = settle_mitsuba_bump,
};

}  // namespace relume
