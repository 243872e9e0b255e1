// A BRDF by one name, for tools that take no material file: a lobe, a pair of them, or a measured table.
#pragma once

#include <string>

#include "host/materials.h"

namespace relume {

/// "ggx" (the lobe, or both where both halves have one of the name), "lambert+ggx" (diffuse + specular), or a MERL table, "gold.binary". Error{input}
/// lists the names.
Material material_named(const std::string& brdf);

}  // namespace relume
