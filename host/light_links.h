// Light linking: lights that shine on some objects alone, as groups that are shaded apart and weighed by those objects' share of each pixel.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "gbuffer/object_ids.h"
#include "host/light_records.h"

namespace relume {

/// Lights that shine on the same objects.
struct LightGroup {
  std::array<int, LIGHT_COUNT + 1> begin{};  ///< of the records, those of each type: [begin[t], begin[t + 1])
  glm::dvec3 ambient{0};                     ///< sum of its ambient lights' radiance
  double ambient_fraction = 0;               ///< sum of its ambient lights' fractions
  const ObjectIds* objects = nullptr;        ///< whose ids they are; null: it shines on everything
  std::set<std::uint32_t> ids;
  bool exclude = false;  ///< it shines on all but them

  bool linked() const { return objects != nullptr; }
};

/// All lights of a rig. The first group shines on everything, and is all there is where no light is linked.
class LightLinks {
 public:
  /// Finds the objects. Their layers are added to `reading.roles`; `taken`: the layer that materials take their ids from, or null. Throws
  /// Error{input} naming the light.
  LightLinks(const std::vector<Light>& lights, const ExrFile& file, Reading& reading, const ObjectIds* taken,
             const EnvironmentOptions& environments = {});
  LightLinks(const LightLinks&) = delete;  // groups point into it
  LightLinks& operator=(const LightLinks&) = delete;

  const std::vector<LightRecord>& records() const { return records_; }
  const std::vector<RigLight>& lights() const { return lights_; }
  const std::vector<DeviceEnvironment>& environments() const { return environments_; }
  const std::vector<LightGroup>& groups() const { return groups_; }
  /// For read_gbuffer.
  std::vector<std::string> roles() const;
  std::vector<std::string> notes() const;

 private:
  LightGroup group_of(const Light& light, const ExrFile& file, Reading& reading);

  std::string numbers_;                                       ///< the layer of plain ids in use: only one can be read at a time
  std::map<std::pair<std::string, bool>, ObjectIds> layers_;  ///< by the name that a rig gives, and whether it speaks of names
  std::vector<LightGroup> groups_{LightGroup{}};
  std::vector<LightRecord> records_;
  std::vector<RigLight> lights_;
  std::vector<DeviceEnvironment> environments_;
  std::vector<std::string> environment_notes_;
};

/// How much of the group's light each pixel takes, 0..1.
std::vector<float> weights_of(const LightGroup& group, const GBuffer& gbuffer);

/// Adds three planes from `from`, weighed, to those from `to`.
void add_weighed(Planes& planes, int from, int to, const std::vector<float>& weights);
/// Weighs three planes where they are.
void weigh(Planes& planes, int first, const std::vector<float>& weights);

}  // namespace relume
