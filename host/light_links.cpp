// LightLinks: lights gathered by what they shine on, and their light weighed.
#include "host/light_links.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <limits>

#include "gbuffer/error.h"
#include "host/json.h"

namespace relume {
namespace {

bool is_number(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

bool same_objects(const LightGroup& a, const LightGroup& b) { return a.objects == b.objects && a.ids == b.ids && a.exclude == b.exclude; }

constexpr std::size_t grain = 1 << 14;  // pixels that one task takes: enough to hide the scheduler

template <class Body>
void for_values(std::size_t count, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) body(i);
  });
}

}  // namespace

LightLinks::LightLinks(const std::vector<Light>& lights, const ExrFile& file, Reading& reading, const ObjectIds* taken,
                       const EnvironmentOptions& environments) {
  if (taken && !taken->is_cryptomatte()) numbers_ = taken->name();
  std::vector<std::vector<Light>> members(1);  // of each group
  for (const Light& light : lights) {
    const LightGroup group = group_of(light, file, reading);
    const auto found = std::find_if(groups_.begin(), groups_.end(), [&](const LightGroup& g) { return same_objects(g, group); });
    const auto place = std::size_t(found - groups_.begin());
    if (found == groups_.end()) {
      groups_.push_back(group);
      members.emplace_back();
    }
    members[place].push_back(light);
  }
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    LightRecords own = light_records(members[g], environments);
    groups_[g].ambient = own.ambient;
    groups_[g].ambient_fraction = own.ambient_fraction;
    for (std::size_t type = 0; type < own.begin.size(); ++type) groups_[g].begin[type] = int(records_.size()) + own.begin[type];
    const int first = int(records_.size()), first_environment = int(environments_.size());
    for (const RigLight& light : own.lights)
      lights_.push_back(
          {light.name, first + light.begin, first + light.end, light.environment < 0 ? -1 : first_environment + light.environment, int(g)});
    std::move(own.environments.begin(), own.environments.end(), std::back_inserter(environments_));
    records_.insert(records_.end(), own.records.begin(), own.records.end());
    environment_notes_.insert(environment_notes_.end(), own.notes.begin(), own.notes.end());
  }
}

LightGroup LightLinks::group_of(const Light& light, const ExrFile& file, Reading& reading) {
  if (light.include.empty() && light.exclude.empty()) return {};
  LightGroup group;
  group.exclude = light.include.empty();
  const std::vector<std::string>& objects = group.exclude ? light.exclude : light.include;
  const bool by_names = !std::all_of(objects.begin(), objects.end(), is_number);
  const auto [place, fresh] = layers_.try_emplace({light.ids, by_names && light.ids.empty()}, file, reading, light.ids, by_names);
  ObjectIds& layer = place->second;
  const std::string who = "light " + in_quotes(light.name);
  if (!layer.is_cryptomatte()) {
    if (numbers_.empty()) numbers_ = layer.name();
    if (numbers_ != layer.name())
      throw Error(ErrorKind::input, who + ": takes ids from layer " + in_quotes(layer.name()) + " where others take them from " +
                                        in_quotes(numbers_) + " (one layer of numbers is read at a time; a Cryptomatte may stand beside it)");
  }
  const std::vector<std::uint32_t> ids = layer.ids_of(objects, who);
  group.ids.insert(ids.begin(), ids.end());
  group.objects = &layer;
  return group;
}

std::vector<std::string> LightLinks::roles() const {
  std::vector<std::string> roles;
  for (const auto& [name, layer] : layers_) roles.insert(roles.end(), layer.roles().begin(), layer.roles().end());
  return roles;
}

std::vector<std::string> LightLinks::notes() const {
  std::vector<std::string> notes = environment_notes_;
  for (const auto& [name, layer] : layers_) notes.insert(notes.end(), layer.notes().begin(), layer.notes().end());
  return notes;
}

std::vector<float> weights_of(const LightGroup& group, const GBuffer& gbuffer) {
  std::vector<float> weights = group.objects->shares(gbuffer, group.ids);
  if (group.exclude)
    for (float& weight : weights) weight = 1 - weight;
  return weights;
}

void add_weighed(Planes& planes, int from, int to, const std::vector<float>& weights) {
  constexpr float most = std::numeric_limits<float>::max();  // what is written is finite
  for (int c = 0; c < 3; ++c) {
    const float* const source = planes.plane(from + c);
    float* const sum = planes.plane(to + c);
    for_values(weights.size(), [&](std::size_t i) { sum[i] = std::clamp(sum[i] + weights[i] * source[i], -most, most); });
  }
}

void weigh(Planes& planes, int first, const std::vector<float>& weights) {
  for (int c = 0; c < 3; ++c) {
    float* const values = planes.plane(first + c);
    for_values(weights.size(), [&](std::size_t i) { values[i] *= weights[i]; });
  }
}

}  // namespace relume
