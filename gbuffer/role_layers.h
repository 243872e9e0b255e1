// Layers put to roles: by name, and by the components that the role needs.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "gbuffer/convention.h"
#include "gbuffer/reading.h"

namespace relume {

/// A layer and the name that it goes by: its own, or what a header says that it holds.
struct NamedLayer {
  const Layer* layer;
  std::string name;
};
std::vector<NamedLayer> named_layers(const std::vector<Layer>& layers, const std::function<std::string(const Layer&)>& name);

/// The layer's channels as the role takes them: three for a direction or a colour, one for depth, ids, coverage (its alpha) and other numbers, two
/// for uv, else what there is. No channels where the layer lacks them.
RoleLayer as_role(const Layer& layer, const std::string& role);

/// Gives the role the first layer that bears one of the alias's names (compared normalised, in their order, the whole name or what follows its last
/// dot) and has its components. Remembers the names. A role that has a layer already keeps it.
void assign(Reading& reading, const std::vector<NamedLayer>& layers, const Alias& alias);

/// Puts down what a name says of the role's space or kind.
void apply(Says says, const std::string& role, Reading& reading);

/// Layers of the chosen view layer and view, those without one included.
std::vector<Layer> chosen_layers(const std::vector<Layer>& layers, const std::string& view_layer, const std::string& view);

/// The layer's name for people: with the view layer if asked for; "RGBA" for root channels.
std::string display_name(const Layer& layer, bool with_view_layer);

}  // namespace relume
