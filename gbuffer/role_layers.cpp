// Layers put to roles.
#include "gbuffer/role_layers.h"

#include <algorithm>
#include <set>
#include <string_view>

#include "gbuffer/roles.h"

namespace relume {
namespace {

void add(RoleLayer& role, const Component* component) {
  role.channels.push_back(component->channel);
  role.types.push_back(component->type);
}

/// The first of these components that there is; '0' stands for a bare channel.
bool add_first(RoleLayer& role, const Layer& layer, std::string_view letters) {
  for (const char letter : letters) {
    if (const Component* const component = layer.component(letter == '0' ? '\0' : letter)) {
      add(role, component);
      return true;
    }
  }
  return false;
}

bool add_all(RoleLayer& role, const Layer& layer, std::string_view letters) {
  if (!std::all_of(letters.begin(), letters.end(), [&](char c) { return layer.component(c); })) return false;
  for (const char letter : letters) add(role, layer.component(letter));
  return true;
}

}  // namespace

RoleLayer as_role(const Layer& layer, const std::string& role) {
  const Role* const known = find_role(role);
  const int wanted = known ? known->components : 0;  // 0: a layer that a material names: what there is
  constexpr std::string_view any_number = "0itzxruyvgb";
  RoleLayer result{layer.part, display_name(layer, false), {}, {}};
  if (role == "coverage") {  // an alpha, or all that a layer of that name has; never the red of a picture
    add_first(result, layer, layer.components.size() == 1 ? "a0xriz" : "a");
  } else if (role == "uv") {
    add_all(result, layer, "uv") || add_all(result, layer, "xy") || add_all(result, layer, "rg");
  } else if (wanted == 1) {
    add_first(result, layer, any_number);
  } else if (!add_all(result, layer, "xyz") && !add_all(result, layer, "rgb") && !add_all(result, layer, "uvw") && wanted != 3) {
    add_all(result, layer, "uv") || add_first(result, layer, any_number);
  }
  return result;
}

std::vector<NamedLayer> named_layers(const std::vector<Layer>& layers, const std::function<std::string(const Layer&)>& name) {
  std::vector<NamedLayer> named;
  for (const Layer& layer : layers) named.push_back({&layer, name(layer)});
  return named;
}

void assign(Reading& reading, const std::vector<NamedLayer>& layers, const Alias& alias) {
  std::string& tried = reading.looked_for[alias.role];
  for (const char* name : alias.names) tried += (tried.empty() ? "" : ", ") + std::string(name);
  for (const bool whole : {true, false}) {
    for (const char* name : alias.names) {
      for (const NamedLayer& layer : layers) {
        if (reading.roles.contains(alias.role)) return;
        const std::string compared = whole ? layer.name : layer.name.substr(layer.name.rfind('.') + 1);
        if (normalised(compared) != normalised(name)) continue;
        RoleLayer candidate = as_role(*layer.layer, alias.role);
        if (candidate.channels.empty()) continue;
        reading.roles[alias.role] = std::move(candidate);
        apply(alias.says, alias.role, reading);
      }
    }
  }
}

void apply(Says says, const std::string& role, Reading& reading) {
  if (says == Says::distance) reading.depth_kind = DepthKind::distance;
  if (role != "normal" && role != "position") return;
  const bool seen = says == Says::camera || says == Says::camera_forward;
  Space& space = role == "normal" ? reading.normal_space : reading.position_space;
  Axes& axes = role == "normal" ? reading.normal_axes : reading.position_axes;
  if (says == Says::world) space = Space::world;
  if (says == Says::view_ray) space = Space::view_ray;
  if (seen) space = Space::camera;
  if (says == Says::camera_forward) axes.sign[2] = -1;
}

std::vector<Layer> chosen_layers(const std::vector<Layer>& layers, const std::string& view_layer, const std::string& view) {
  std::vector<Layer> chosen;
  std::set<std::string> seen;
  const auto wanted = [&](const Layer& layer) { return layer.view_layer.empty() || layer.view_layer == view_layer; };
  for (const Layer& layer : layers) {
    if (!wanted(layer) || layer.view != view) continue;
    chosen.push_back(layer);
    seen.insert(layer.name);
  }
  if (view.empty()) return chosen;
  for (const Layer& layer : layers)  // OpenEXR names no view where it is the default one
    if (wanted(layer) && layer.view.empty() && !seen.contains(layer.name)) chosen.push_back(layer);
  return chosen;
}

std::string display_name(const Layer& layer, bool with_view_layer) {
  const std::string name = layer.name.empty() ? "RGBA" : layer.name;
  return with_view_layer && !layer.view_layer.empty() ? layer.view_layer + '.' + name : name;
}

}  // namespace relume
