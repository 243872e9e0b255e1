// Subjects live/<change>/<device>: a resident frame of 1920x1080 under 8 lights: shaded whole, and one light of the 8 moved to and fro, unranged or
// with a range that reaches a tenth of the picture.
#include "bench/ground_frame.h"
#include "bench/resident_subject.h"
#include "bench/suites.h"
#include "gbuffer/error.h"
#include "host/live_frame.h"

namespace relume::bench {
namespace {

constexpr int lights = 8;
constexpr const char* changes[] = {"all", "moved", "moved_ranged"};

/// A live frame and what it refers to.
struct Subjected {
  std::shared_ptr<Device> device;
  Reading reading;
  std::optional<Binding> binding;
  std::optional<LiveFrame> frame;
  std::vector<Light> rig;
};

std::shared_ptr<Subjected> make(const std::shared_ptr<Device>& device, Size size, bool ranged) {
  const auto made = std::make_shared<Subjected>();
  made->device = device;
  const FrameSource source = ground_source(size.width, size.height);
  for (const std::string& role : source.roles) made->reading.roles[role] = {};
  made->reading.camera = source.camera;
  made->binding.emplace(
      material_named("lambert+ggx"), std::nullopt, "bench", [](const std::string&) -> RoleLayer { return {}; }, made->reading);
  made->frame.emplace(*device, source.make(made->binding->roles(), made->binding->spare_planes()), *made->binding, made->reading);
  made->rig = ground_lights(LightType::point, lights);
  if (ranged) {
    made->rig[0].position = {0, 1, 0};
    made->rig[0].falloff = Falloff::windowed;
    made->rig[0].range = 3.5;  // of the 20 x 20 that are seen
  }
  return made;
}

/// The first light moves to the other side and back.
void move(Subjected& s) {
  s.rig[0].position.x = -s.rig[0].position.x + 0.25;
  s.frame->change_light(0, s.rig[0]);
}

/// After moves the picture has the bits of a frame that was made with the lights as they are now.
std::string checked(Subjected& s, Size size, bool ranged) {
  for (int k = 0; k < 3; ++k) move(s);
  const std::shared_ptr<Subjected> fresh = make(s.device, size, ranged);
  fresh->frame->set_lights(s.rig);
  fresh->frame->change_light(0, s.rig[0]);
  for (int plane = 0; plane < 3; ++plane)
    for (std::int64_t i = 0; i < s.frame->window().pixels(); ++i)
      if (s.frame->radiance().plane(plane)[i] != fresh->frame->radiance().plane(plane)[i])
        throw Error(ErrorKind::device, "a moved light leaves other bits than shading anew");
  return "equal";
}

Group group_of(const BenchDevice& device, Size size) {
  const std::string all = std::string("live/") + changes[0] + "/" + device.label;
  Group group;
  for (const char* change : changes) group.names.push_back(std::string("live/") + change + "/" + device.label);
  for (int k : {1, 2}) group.claims.push_back({Measure::time_over, group.names[std::size_t(k)], all, "in times of shading all 8 lights", 0.25});
  group.make = [&device, size, names = group.names](const std::function<bool(const std::string&)>& is_wanted) {
    std::vector<Subject> made;
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (!is_wanted(names[k])) continue;
      const bool ranged = k == 2;
      const std::shared_ptr<Subjected> subjected = make(device.open(), size, ranged);
      subjected->frame->set_lights(subjected->rig);
      if (k == 0) {
        made.push_back({names[k], [subjected] { subjected->frame->set_lights(subjected->rig); }, {}, ""});
        made.back().work.pixel_lights = {{"brute", double(size.width) * size.height * lights}};
        continue;
      }
      made.push_back({names[k], [subjected] { move(*subjected); }, {}, checked(*subjected, size, ranged)});
      made.back().work.pixel_lights = {{"touched", double(size.width) * size.height * subjected->frame->touched()}};
    }
    return made;
  };
  return group;
}

}  // namespace

std::vector<Group> live_groups(const Bench& bench) {
  std::vector<Group> groups;
  const Size size = bench.options.sizes.empty() ? Size{1920, 1080} : bench.options.sizes.front();
  for (const BenchDevice& device : bench.devices) groups.push_back(group_of(device, size));
  return groups;
}

}  // namespace relume::bench
