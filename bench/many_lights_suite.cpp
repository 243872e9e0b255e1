// Subjects many_lights/<scene>/<device>: 1024 ranged lights over a stored frame, the three settings of the comparison with ISPC's example, on all
// compute units and, with "_1_thread", on one. A go culls and shades: nothing is kept from the last but, with "_held", what bounds the pixels.
#include "bench/many_lights_scene.h"
#include "bench/resident_subject.h"
#include "bench/suites.h"
#include "bench/tile_statistics.h"

namespace relume::bench {
namespace {

struct Setting {
  const char* name;
  Size size;
  double reach;
};
constexpr Setting settings[] = {{"1280x720", {1280, 720}, 1}, {"1280x720_r2", {1280, 720}, 2}, {"1920x1200", {1920, 1200}, 1}};
constexpr unsigned seed = 7;

constexpr struct {
  Bounds bounds;
  const char* suffix;
} variants[] = {{Bounds::anew, ""}, {Bounds::held, "_held"}};

Group group_of(const Bench& bench, const Setting& setting) {
  const std::string prefix = std::string("many_lights/") + setting.name + "/";
  Group group;
  for (const BenchDevice& d : bench.devices)
    for (const auto& variant : variants) {
      group.names.push_back(prefix + d.label + variant.suffix);
      if (!d.is_twin()) group.names.push_back(prefix + d.label + variant.suffix + "_1_thread");
    }
  group.make = [&bench, &setting, prefix](const std::function<bool(const std::string&)>& is_wanted) {
    const ManyLights scene = many_lights(setting.size.width, setting.size.height, setting.reach, seed);
    const auto frame = std::make_shared<ResidentFrame>(scene.source, material_named("lambert_original+blinn_phong"));
    frame->set_lights(scene.lights);
    const TileStatistics tiles = tile_statistics(frame->gbuffer(), scene.lights);
    std::vector<Subject> made;
    const auto add = [&](const std::string& name, const std::shared_ptr<Device>& device, const Roof& roof, Bounds bounds) {
      if (!is_wanted(name) || !device) return;
      made.push_back(culled_subject(name, frame, device, roof, tiles.in_range, bounds));
      made.back().work.pixel_lights = {{"culled", tiles.culled}, {"in range", tiles.in_range}, {"brute", tiles.brute}};
    };
    for (const BenchDevice& d : bench.devices)
      for (const auto& [bounds, suffix] : variants) {
        const std::string name = prefix + d.label + suffix;
        add(name, d.open(), d.roof(), bounds);
        add(name + "_1_thread", d.open_one_thread(), d.roof(1), bounds);
      }
    return made;
  };
  return group;
}

}  // namespace

std::vector<Group> many_lights_groups(const Bench& bench) {
  std::vector<Group> groups;
  for (const Setting& setting : settings) groups.push_back(group_of(bench, setting));
  return groups;
}

}  // namespace relume::bench
