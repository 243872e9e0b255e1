// What layers' names say in words that renderers and artists share: "WorldNormals", "position_ws", "N_camera", "basecolor".
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gbuffer/role_layers.h"

namespace relume {

struct NameMeaning {
  std::string role;
  Says says = Says::nothing;
  bool unsigned_normals = false;  ///< "encoded normals": 0..1 for -1..1
  int doubt = 0;                  ///< among layers of one role that with the least is taken
};

/// The role that a name speaks of, or nothing. A name with a word in it that is not known speaks of nothing: "diffuse_variance" is no albedo.
std::optional<NameMeaning> meaning_of(const std::string& layer_name);

/// Gives the roles that are still open to the layers whose names speak of them most plainly.
void assign_common_names(Reading& reading, const std::vector<NamedLayer>& layers);

/// An albedo called just "diffuse", with a warning: some programs call the unlit colour so, others the light. A Convention's `assign`.
void take_diffuse(const ExrFile& file, const std::vector<Layer>& layers, Reading& reading);

}  // namespace relume
