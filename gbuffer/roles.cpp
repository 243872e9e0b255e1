// The list of roles from the two that it is made of.
#include "gbuffer/roles.h"

#include <algorithm>

#include "kernels/parameters.h"

namespace relume {

const std::vector<Role>& roles() {
  static const std::vector<Role> all = [] {
#define RELUME_ROLE(name, components, meaning) {#name, components, meaning},
#define RELUME_PARAMETER(name, components, fallback, lowest, highest, meaning) {#name, components, meaning},
    std::vector<Role> list{RELUME_ROLES(RELUME_ROLE) RELUME_PARAMETERS(RELUME_PARAMETER)};
#undef RELUME_PARAMETER
#undef RELUME_ROLE
    std::erase_if(list, [](const Role& role) { return role.meaning.starts_with("set by the host") || role.meaning.ends_with("(a file)"); });
    return list;
  }();
  return all;
}

const Role* find_role(std::string_view name) {
  const auto found = std::find_if(roles().begin(), roles().end(), [&](const Role& role) { return role.name == name; });
  return found == roles().end() ? nullptr : &*found;
}

}  // namespace relume
