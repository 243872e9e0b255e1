// A glTF's scene as a rig needs it: the lights and cameras, each in its place. For host/rig_gltf.cpp alone.
#pragma once

#include <tiny_gltf.h>

#include <glm/mat4x4.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "host/json.h"

namespace relume {

/// A light or camera where the scene has it.
struct Placed {
  int index = -1;    ///< in model.lights or model.cameras
  std::string name;  ///< the node's, else its own, else "<type><index>" or "camera"
  glm::dmat4 world_from_node{1};
};

struct GltfScene {
  tinygltf::Model model;                ///< without buffers, meshes, materials and images
  std::vector<Placed> lights, cameras;  ///< depth first
};

/// `text` is glTF's JSON, which `json` is the tree of; `file` is how errors name it. Error{input} for what glTF 2.0 does not allow.
GltfScene read_gltf_scene(const Json& json, std::string_view text, const std::string& file);

}  // namespace relume
