// environment_mappings: the list as C++ sees it.
#include "host/environment_mapping.h"

namespace relume {

const std::vector<EnvironmentMapping>& environment_mappings() {
  constexpr bool border = true, centre = false;
#define RELUME_ITEM(name, up, left, quarter, columns, rows, source) \
  {#name, glm::dmat3(glm::dvec3 left, glm::dvec3 quarter, glm::dvec3 up), columns, rows, source},
  static const std::vector<EnvironmentMapping> list = {RELUME_ENVIRONMENT_MAPPINGS(RELUME_ITEM)};
#undef RELUME_ITEM
  return list;
}

}  // namespace relume
