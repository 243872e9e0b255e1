// Layers put to roles: by alias, and by the components that the role needs.
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "gbuffer/reading.h"

namespace relume {

/// The layer's channels as the role takes them: three for a direction, one for depth, ids, coverage (its alpha) and other numbers, two for uv, else
/// what there is. No channels where the layer lacks them.
RoleLayer as_role(const Layer& layer, const std::string& role);

/// Gives the role the first layer that bears one of the names (compared normalised, in their order) and has its components. Remembers the names.
/// A role that has a layer already keeps it.
void assign(Reading& reading, const std::vector<Layer>& layers, const std::string& role, std::initializer_list<const char*> names);

/// Layers of the chosen view layer and view, those without one included.
std::vector<Layer> chosen_layers(const std::vector<Layer>& layers, const std::string& view_layer, const std::string& view);

/// The layer's name for people: with the view layer if asked for; "RGBA" for root channels.
std::string display_name(const Layer& layer, bool with_view_layer);

}  // namespace relume
