// The two kinds of rig file, for host/rig.cpp alone.
#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <string_view>

#include "host/json.h"
#include "host/rig.h"

namespace relume {

/// `file` is how errors name it.
Rig read_json_rig(const Json& json, const std::string& file);

/// `text`: glTF's JSON, which `json` is the tree of.
Rig read_gltf_rig(const Json& json, std::string_view text, const std::string& file, const RigOptions& options);

/// Of any length that is not zero, however small; zero gives zero.
glm::dvec3 unit_or_zero(const glm::dvec3& direction);

/// What kernels cannot hold in single precision, as the key that is at fault; empty where all is well.
std::string beyond_single(const Light& light);

}  // namespace relume
