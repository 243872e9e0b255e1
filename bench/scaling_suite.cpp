// Subjects scaling/<brdf>/<device>/<threads>: the same frame on parts of the device with 1, 2, 4 ... compute units, and on all of them.
#include "bench/ground_frame.h"
#include "bench/resident_subject.h"
#include "bench/suites.h"

namespace relume::bench {
namespace {

constexpr const char* pairs[] = {"lambert+cook_torrance", "lambert+ggx", "lambert+none"};
constexpr int lights = 64;

/// 1, 2, 4 ... and the device's own number.
std::vector<int> thread_counts(const BenchDevice& device) {
  std::vector<int> counts;
  const int all = device.compute_units();
  for (int n = 1; n < all; n *= 2) counts.push_back(n);
  if (all > 1) counts.push_back(all);
  return counts;
}

Group group_of(const BenchDevice& device, const std::string& pair) {
  const std::string prefix = "scaling/" + pair + "/" + device.label + "/";
  Group group;
  for (const int threads : thread_counts(device)) group.names.push_back(prefix + std::to_string(threads));
  if (group.names.size() > 1) group.claims.push_back({Measure::rate_over, group.names[1], group.names[0], "over one compute unit", 1.9});
  group.make = [&device, pair, prefix](const std::function<bool(const std::string&)>& is_wanted) {
    const auto frame = std::make_shared<ResidentFrame>(ground_source(640, 360), material_named(pair));
    frame->set_lights(ground_lights(LightType::point, lights));
    std::vector<Subject> made;
    for (const int threads : thread_counts(device)) {
      const std::string name = prefix + std::to_string(threads);
      if (!is_wanted(name)) continue;
      if (const std::shared_ptr<Device> part = device.open_threads(threads))
        made.push_back(resident_subject(name, frame, part, device.roof(threads)));
    }
    return made;
  };
  return group;
}

}  // namespace

std::vector<Group> scaling_groups(const Bench& bench) {
  std::vector<Group> groups;
  for (const BenchDevice& device : bench.devices)
    for (const char* pair : pairs)
      if (device.info.is_cpu && !device.is_twin() && device.compute_units() > 1) groups.push_back(group_of(device, pair));
  return groups;
}

}  // namespace relume::bench
