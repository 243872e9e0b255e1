// print_costs: a Markdown table, for docs/performance.md.
#include "bench/cost_table.h"

#include <cstdio>

#include "bench/ground_frame.h"
#include "bench/resident_subject.h"
#include "host/lobes.h"

namespace relume::bench {
namespace {

void print_row(std::ostream& out, const std::string& pair, LightType type, const std::string& falloff) {
  ResidentFrame frame(ground_source(8, 8), material_named(pair));
  std::vector<Light> lights = ground_lights(type, 2);
  for (Light& light : lights) {
    if (falloff == "none") continue;
    light.falloff = falloff == "linear" ? Falloff::linear : Falloff::windowed;
    light.range = 100;
    light.range_begin = 10;
  }
  frame.set_lights(lights);
  const ShadingCost cost = cost_of(frame);
  const Operations& l = cost.light;
  const std::string light = std::string(light_types()[std::size_t(type)].name) + (falloff == "none" ? "" : ", " + falloff);
  char text[256];
  std::snprintf(text, sizeof text, "| %s | %s | %g | %g | %g | %g | %g | %g | %g | **%g** | %g | %g |\n", pair.c_str(), light.c_str(), l.add,
                l.multiply, l.fused, l.divide, l.root, l.compare + l.select, l.whole, l.flops(), cost.pixel.flops(), cost.pixel.bytes());
  out << text;
}

}  // namespace

void print_costs(std::ostream& out) {
  out << "| lobes | light | + - | * | of both, fused | / | root | compare, choose | whole | **flop a light** | flop a pixel | bytes a pixel |\n"
         "|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const Lobe& d : diffuse_lobes()) print_row(out, std::string(d.name) + "+none", LightType::point, "none");
  for (const Lobe& s : specular_lobes()) print_row(out, "none+" + std::string(s.name), LightType::point, "none");
  for (const char* pair : {"lambert+cook_torrance", "lambert+ggx"}) print_row(out, pair, LightType::point, "none");
  for (const char* falloff : {"windowed", "linear"}) print_row(out, "lambert+none", LightType::point, falloff);
  for (const LightType type : {LightType::spot, LightType::directional}) print_row(out, "lambert+none", type, "none");
}

}  // namespace relume::bench
