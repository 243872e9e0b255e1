// A glTF's scene, through tinygltf: properties checked, buffers and images unread, every light and camera placed in the world.
#include "host/gltf_scene.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/quaternion_double.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <nlohmann/json.hpp>
#include <numbers>

#include "gbuffer/error.h"

namespace relume {
namespace {

constexpr const char* extension = "KHR_lights_punctual";

[[noreturn]] void fail(const std::string& file, const std::string& what) { throw Error(ErrorKind::input, file + ": glTF: " + what); }

/// tinygltf takes a property of the wrong type for one that is absent; a light at the wrong place is worse than an error.
void check_types(const Json& json, const std::string& file) {
  const auto each = [&](const Json* items, const std::string& name, auto check) {
    if (!items) return;
    if (items->type != Json::Type::array)
      throw Error(ErrorKind::input, file + ":" + std::to_string(items->line) + ": " + in_quotes(name) + ": must be an array");
    for (std::size_t i = 0; i < items->items.size(); ++i) check(ObjectReader(items->items[i], file, name + "[" + std::to_string(i) + "]"));
  };
  each(json.find("nodes"), "nodes", [&](const ObjectReader& node) {
    node.numbers("matrix", 16);
    node.numbers("rotation", 4);
    node.numbers("translation", 3);
    node.numbers("scale", 3);
    node.number("camera");
    node.string("name");
    const Json* extensions = node.json().find("extensions");
    if (const Json* light = extensions ? extensions->find(extension) : nullptr) {
      const ObjectReader reader(*light, file, node.place());
      const double index = reader.number("light").value_or(-1);
      if (!(index >= 0 && index < 1e9 && index == std::floor(index))) reader.fail("light", "must be the index of a light");
    }
  });
  const Json* extensions = json.find("extensions");
  const Json* lights = extensions ? extensions->find(extension) : nullptr;
  each(lights ? lights->find("lights") : nullptr, "lights", [&](const ObjectReader& light) {
    if (light.number("intensity").value_or(1) < 0) light.fail("intensity", "must not be negative");
    light.numbers("color", 3);
    if (light.number("range").value_or(1) <= 0) light.fail("range", "must be above 0");
    if (const Json* spot = light.json().find("spot")) {
      const ObjectReader cone(*spot, file, light.place() + ": spot");
      const double outer = cone.number("outerConeAngle").value_or(std::numbers::pi / 4), inner = cone.number("innerConeAngle").value_or(0);
      // 1e-6: pi/2 written in single precision is above pi/2.
      if (outer < 0 || outer > std::numbers::pi / 2 + 1e-6) cone.fail("outerConeAngle", "must be in 0..pi/2");
      if (inner < 0 || inner > outer) cone.fail("innerConeAngle", "must lie between 0 and \"outerConeAngle\"");
    }
  });
}

/// What lights and cameras need of the file. The rest, above all buffers and images, is left unread, so that none of it has to be there.
std::string lights_and_cameras(std::string_view text) {
  const auto keep = [](int depth, nlohmann::json::parse_event_t event, const nlohmann::json& key) {
    if (event != nlohmann::json::parse_event_t::key || depth != 1) return true;
    for (const char* name : {"asset", "scene", "scenes", "nodes", "cameras", "extensions"})
      if (key == name) return true;
    return false;
  };
  return nlohmann::json::parse(text, keep).dump();
}

tinygltf::Model load(std::string_view text, const std::string& file) {
  const std::string part = lights_and_cameras(text);
  tinygltf::Model model;
  tinygltf::TinyGLTF loader;
  loader.SetImageLoader([](tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*, int, void*) { return true; }, nullptr);
  std::string error, warning;
  if (!loader.LoadASCIIFromString(&model, &error, &warning, part.data(), static_cast<unsigned>(part.size()), "")) {
    std::replace(error.begin(), error.end(), '\n', ' ');
    fail(file, "" + error.substr(0, error.find_last_not_of(' ') + 1));
  }
  if (!model.asset.version.starts_with("2.")) fail(file, "version " + in_quotes(model.asset.version) + " (2.0 is known)");
  return model;
}

glm::dmat4 local_matrix(const tinygltf::Node& node) {
  if (node.matrix.size() == 16) return glm::make_mat4(node.matrix.data());
  glm::dmat4 matrix(1);
  if (node.rotation.size() == 4) {
    const glm::dquat rotation(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);
    if (glm::length(rotation) > 0) matrix = glm::dmat4(glm::mat3_cast(glm::normalize(rotation)));
  }
  if (node.scale.size() == 3)
    for (int axis = 0; axis < 3; ++axis) matrix[axis] *= node.scale[axis];
  if (node.translation.size() == 3) matrix[3] = glm::dvec4(node.translation[0], node.translation[1], node.translation[2], 1);
  return matrix;
}

/// The index of the node's light, or -1.
int light_of(const tinygltf::Node& node) {
  const auto found = node.extensions.find(extension);
  return found != node.extensions.end() && found->second.Has("light") ? found->second.Get("light").GetNumberAsInt() : -1;
}

/// The first name that is not empty.
std::string first_of(const std::vector<std::string>& names) {
  return *std::find_if(names.begin(), names.end() - 1, [](const std::string& name) { return !name.empty(); });
}

std::vector<int> roots_of(const tinygltf::Model& model, const std::string& file) {
  const int scene = std::max(model.defaultScene, 0);
  if (scene < static_cast<int>(model.scenes.size())) return model.scenes[scene].nodes;
  if (!model.scenes.empty()) fail(file, "scene " + std::to_string(scene) + " is not there (has " + std::to_string(model.scenes.size()) + ")");
  std::vector<bool> is_child(model.nodes.size());
  for (const tinygltf::Node& node : model.nodes)
    for (const int child : node.children)
      if (child >= 0 && child < static_cast<int>(is_child.size())) is_child[child] = true;
  std::vector<int> roots;
  for (std::size_t i = 0; i < is_child.size(); ++i)
    if (!is_child[i]) roots.push_back(static_cast<int>(i));
  return roots;
}

void check_index(int index, std::size_t count, const std::string& what, const std::string& file) {
  if (index < 0 || index >= static_cast<int>(count))
    fail(file, what + " " + std::to_string(index) + " is not there (has " + std::to_string(count) + ")");
}

/// Adds the light and the camera that the node holds, if any.
void place(const tinygltf::Node& node, const glm::dmat4& world_from_node, GltfScene& scene, const std::string& file) {
  if (const int light = light_of(node); light >= 0) {
    check_index(light, scene.model.lights.size(), "light", file);
    const tinygltf::Light& source = scene.model.lights[light];
    scene.lights.push_back({light, first_of({node.name, source.name, source.type + std::to_string(scene.lights.size())}), world_from_node});
  }
  if (node.camera >= 0) {
    check_index(node.camera, scene.model.cameras.size(), "camera", file);
    scene.cameras.push_back({node.camera, first_of({node.name, scene.model.cameras[node.camera].name, "camera"}), world_from_node});
  }
}

}  // namespace

GltfScene read_gltf_scene(const Json& json, std::string_view text, const std::string& file) {
  check_types(json, file);
  GltfScene scene;
  scene.model = load(text, file);
  const std::vector<tinygltf::Node>& nodes = scene.model.nodes;
  struct Visit {
    int node;
    glm::dmat4 world_from_parent;
  };
  std::vector<Visit> open;  // not recursion: a hostile file may be a chain of a million nodes
  const auto push = [&](const std::vector<int>& children, const glm::dmat4& matrix) {
    for (auto child = children.rbegin(); child != children.rend(); ++child) open.push_back({*child, matrix});
  };
  std::vector<bool> seen(nodes.size());
  push(roots_of(scene.model, file), glm::dmat4(1));
  while (!open.empty()) {
    const Visit visit = open.back();
    open.pop_back();
    check_index(visit.node, nodes.size(), "node", file);
    if (seen[visit.node]) fail(file, "node " + std::to_string(visit.node) + " is reached twice (a node has one parent)");
    seen[visit.node] = true;
    const glm::dmat4 world_from_node = visit.world_from_parent * local_matrix(nodes[visit.node]);
    place(nodes[visit.node], world_from_node, scene, file);
    push(nodes[visit.node].children, world_from_node);
  }
  return scene;
}

}  // namespace relume
