// Subjects growth/ranged/<lights>/<device>: 1024, 10,240 and 102,400 ranged lights whose ranges shrink as they become more, so that as many reach a
// pixel: what culling makes of it.
#include <cmath>

#include "bench/many_lights_scene.h"
#include "bench/resident_subject.h"
#include "bench/suites.h"
#include "bench/tile_statistics.h"

namespace relume::bench {
namespace {

constexpr int counts[] = {1024, 10240, 102400};
/// Over a plane the square root of the number would keep a pixel's lights as many; walls and balls rise out of the shrinking cloud, which this makes
/// up for: 26 lights in range of a pixel each time, to a tenth.
constexpr double shrinking = 0.415;

std::string name_of(int lights, const BenchDevice& device) { return "growth/ranged/" + std::to_string(lights) + "/" + device.label; }

Group group_of(const BenchDevice& device, Size size) {
  Group group;
  for (const int lights : counts) {
    group.names.push_back(name_of(lights, device));
    if (lights > counts[0])
      group.claims.push_back({Measure::time_over, name_of(lights, device), name_of(lights / 10, device), "in times of a tenth of the lights", 1.5});
  }
  group.make = [&device, size](const std::function<bool(const std::string&)>& is_wanted) {
    std::vector<Subject> made;
    for (const int lights : counts) {
      if (!is_wanted(name_of(lights, device))) continue;
      const double shrunk = std::pow(double(counts[0]) / lights, shrinking);
      ManyLights scene = many_lights(size.width, size.height, 2 * shrunk, 7, lights);
      for (Light& light : scene.lights) light.position.y *= shrunk;  // down to the ground that they are to light
      const auto frame = std::make_shared<ResidentFrame>(scene.source, material_named("lambert_original+blinn_phong"));
      frame->set_lights(scene.lights);
      const TileStatistics tiles = tile_statistics(frame->gbuffer(), scene.lights);
      made.push_back(culled_subject(name_of(lights, device), frame, device.open(), device.roof(), tiles.in_range));
      made.back().work.pixel_lights = {{"in range", tiles.in_range}, {"culled", tiles.culled}, {"brute", tiles.brute}};
    }
    return made;
  };
  return group;
}

}  // namespace

std::vector<Group> growth_groups(const Bench& bench) {
  std::vector<Group> groups;
  const Size size = bench.options.sizes.empty() ? Size{1280, 720} : bench.options.sizes.front();
  for (const BenchDevice& device : bench.devices) groups.push_back(group_of(device, size));
  return groups;
}

}  // namespace relume::bench
