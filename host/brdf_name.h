// A BRDF by one name, for tools that take no material file: a lobe, or a pair of them.
#pragma once

#include <string>

#include "host/materials.h"

namespace relume {

/// "ggx" (the lobe, or both where both halves have one of the name), "lambert+ggx" (diffuse + specular). Error{input} lists the names.
Material material_named(const std::string& brdf);

}  // namespace relume
