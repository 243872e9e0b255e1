// Subjects growth/ranged/<lights>/<device>: 1024, 10,240 and 102,400 ranged lights whose ranges shrink as they become more, so that as many reach a
// pixel: what culling makes of it. growth/panels/...: as many unranged lights, through a light tree within 1%: 64 glowing panels, sampled more and
// more finely.
#include <cmath>
#include <random>

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

constexpr double tree_error = 0.01;

std::string name_of(const char* kind, int lights, const BenchDevice& device) {
  return std::string("growth/") + kind + "/" + std::to_string(lights) + "/" + device.label;
}

/// A group without its subjects.
Group named_group(const char* kind, const BenchDevice& device, double goal) {
  Group group;
  for (const int lights : counts) {
    group.names.push_back(name_of(kind, lights, device));
    if (lights > counts[0])
      group.claims.push_back({Measure::time_over, group.names.back(), name_of(kind, lights / 10, device), "in times of a tenth of the lights", goal});
  }
  return group;
}

/// Horizontal panels of 4x4 above the scene's heights; each light is a random point of the next one. All of them together are as bright whatever
/// their number.
void spread_over_panels(std::vector<Light>& lights) {
  constexpr int panels = 64;
  std::mt19937 random(3);
  const auto between = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  std::vector<glm::dvec3> centres;
  for (int k = 0; k < panels; ++k) centres.push_back({between(-90, 90), between(20, 35), between(-90, 90)});
  for (std::size_t k = 0; k < lights.size(); ++k) {
    lights[k].position = centres[k % panels] + glm::dvec3{between(-2, 2), 0, between(-2, 2)};
    lights[k].intensity = glm::dvec3(1, 0.9, 0.8) * (100.0 * counts[0] / double(lights.size()));
    lights[k].falloff = Falloff::inverse_square;
    lights[k].range = lights[k].range_begin = 0;
  }
}

Group panels_group(const BenchDevice& device, Size size) {
  Group group = named_group("panels", device, 3);
  group.make = [&device, size](const std::function<bool(const std::string&)>& is_wanted) {
    std::vector<Subject> made;
    for (const int lights : counts) {
      const std::string name = name_of("panels", lights, device);
      if (!is_wanted(name)) continue;
      ManyLights scene = many_lights(size.width, size.height, 1, 7, lights);
      spread_over_panels(scene.lights);
      const auto frame = std::make_shared<ResidentFrame>(scene.source, material_named("lambert_original+none"));
      frame->set_lights(scene.lights, tree_error);
      made.push_back(cut_subject(name, frame, device.open(), device.roof(), tree_error));
    }
    return made;
  };
  return group;
}

Group group_of(const BenchDevice& device, Size size) {
  Group group = named_group("ranged", device, 1.5);
  group.make = [&device, size](const std::function<bool(const std::string&)>& is_wanted) {
    std::vector<Subject> made;
    for (const int lights : counts) {
      if (!is_wanted(name_of("ranged", lights, device))) continue;
      const double shrunk = std::pow(double(counts[0]) / lights, shrinking);
      ManyLights scene = many_lights(size.width, size.height, 2 * shrunk, 7, lights);
      for (Light& light : scene.lights) light.position.y *= shrunk;  // down to the ground that they are to light
      const auto frame = std::make_shared<ResidentFrame>(scene.source, material_named("lambert_original+blinn_phong"));
      frame->set_lights(scene.lights);
      const TileStatistics tiles = tile_statistics(frame->gbuffer(), scene.lights);
      made.push_back(culled_subject(name_of("ranged", lights, device), frame, device.open(), device.roof(), tiles.in_range, Bounds::anew));
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
  for (const BenchDevice& device : bench.devices) {
    groups.push_back(group_of(device, size));
    groups.push_back(panels_group(device, size));
  }
  return groups;
}

}  // namespace relume::bench
