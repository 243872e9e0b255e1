// Subjects kernel/<brdf>/<light>/<lights>/<size>/<device>/<lanes>: Relume's own kernels over the ground, resident.
#include <map>

#include "bench/ground_frame.h"
#include "bench/resident_subject.h"
#include "bench/suites.h"
#include "host/lobes.h"

namespace relume::bench {
namespace {

struct Case {
  std::string brdf;
  LightType type;
  int lights;
  Size size;
};

const std::vector<int> all_counts{1, 4, 16, 64, 256, 1024, 4096, 16384};
const std::vector<Size> all_sizes{{160, 90}, {320, 180}, {640, 360}, {1920, 1080}, {3840, 2160}};
const std::vector<LightType> all_types{LightType::point, LightType::spot, LightType::directional};

std::string brdf_name(std::string_view diffuse, std::string_view specular) { return std::string(diffuse) + "+" + std::string(specular); }

std::vector<std::string> all_pairs() {
  std::vector<std::string> pairs;
  for (const Lobe& d : diffuse_lobes()) pairs.push_back(brdf_name(d.name, "none"));
  for (const Lobe& s : specular_lobes()) pairs.push_back(brdf_name("none", s.name));
  for (const Lobe& d : diffuse_lobes())
    for (const Lobe& s : specular_lobes()) pairs.push_back(brdf_name(d.name, s.name));
  return pairs;
}

template <class T>
std::vector<T> given_or(const std::vector<T>& given, const std::vector<T>& otherwise) {
  return given.empty() ? otherwise : given;
}

/// Every dimension in full, but for those that options narrow. `open`: a filter chooses; else what no option names keeps to one value.
std::vector<Case> product(const Options& o, bool open) {
  std::vector<std::string> brdfs;
  for (const std::string& brdf : o.brdfs) {
    const Material material = material_named(brdf);
    brdfs.push_back(brdf_name(material.diffuse, material.specular));
  }
  const std::vector<std::string> usual_pair{"lambert+cook_torrance"};
  std::vector<Case> cases;
  for (const std::string& brdf : given_or(brdfs, open ? all_pairs() : usual_pair))
    for (const LightType type : open ? all_types : std::vector{LightType::point})
      for (const int lights : given_or(o.lights, open ? all_counts : std::vector{64}))
        for (const Size size : given_or(o.sizes, open ? all_sizes : std::vector<Size>{{640, 360}})) cases.push_back({brdf, type, lights, size});
  return cases;
}

/// A cut through each dimension: every lobe, then every light count, type and size with Cook-Torrance.
std::vector<Case> chosen_cases() {
  std::vector<Case> cases;
  const std::string pair = "lambert+cook_torrance";
  for (const Lobe& d : diffuse_lobes()) cases.push_back({brdf_name(d.name, "none"), LightType::point, 64, {640, 360}});
  for (const Lobe& s : specular_lobes()) cases.push_back({brdf_name("lambert", s.name), LightType::point, 64, {640, 360}});
  for (const int lights : all_counts) cases.push_back({pair, LightType::point, lights, {160, 90}});
  for (const LightType type : {LightType::spot, LightType::directional}) cases.push_back({pair, type, 64, {640, 360}});
  cases.push_back({pair, LightType::point, 8, {1920, 1080}});
  return cases;
}

std::string name_of(const Case& c, const BenchDevice& device, int lanes) {
  return "kernel/" + c.brdf + "/" + std::string(light_types()[std::size_t(c.type)].name) + "/" + std::to_string(c.lights) + "/" +
         std::to_string(c.size.width) + "x" + std::to_string(c.size.height) + "/" + device.label + "/" + std::to_string(lanes);
}

std::vector<int> lanes_of(const Bench& bench, const BenchDevice& device) {
  if (!bench.options.lanes.empty()) return bench.options.lanes;
  return bench.is_open() ? device.lanes() : std::vector{device.info.lanes};
}

Group group_of(const Bench& bench, const Case& c) {
  std::map<std::string, std::pair<const BenchDevice*, int>> subjects;
  Group group;
  for (const BenchDevice& device : bench.devices)
    for (const int lanes : lanes_of(bench, device)) {
      group.names.push_back(name_of(c, device, lanes));
      subjects[group.names.back()] = {&device, lanes};
      if (c.lights == 8 && c.size.height == 1080) group.claims.push_back({Measure::milliseconds, group.names.back(), "", "takes", 20});
    }
  group.make = [c, subjects](const std::function<bool(const std::string&)>& is_wanted) {
    const auto frame = std::make_shared<ResidentFrame>(ground_source(c.size.width, c.size.height), material_named(c.brdf));
    frame->set_lights(ground_lights(c.type, c.lights));
    std::vector<Subject> made;
    for (const auto& [name, where] : subjects)
      if (is_wanted(name)) made.push_back(resident_subject(name, frame, where.first->open(where.second), where.first->roof()));
    return made;
  };
  return group;
}

}  // namespace

std::vector<Group> kernel_groups(const Bench& bench) {
  const Options& o = bench.options;
  const bool narrowed = !(o.brdfs.empty() && o.lights.empty() && o.sizes.empty());
  std::vector<Group> groups;
  for (const Case& c : bench.is_open() || narrowed ? product(o, bench.is_open()) : chosen_cases()) groups.push_back(group_of(bench, c));
  return groups;
}

}  // namespace relume::bench
