// What layers are for: the parts of a G-buffer, what parameters are made from, and every parameter of a lobe (kernels/parameters.h).
#pragma once

#include <string_view>
#include <vector>

namespace relume {

/// ROLE(name, components, meaning); parameters follow from the kernels' own list.
#define RELUME_ROLES(ROLE)                                                                         \
  ROLE(position, 3, "where the surface is")                                                        \
  ROLE(normal, 3, "the shading normal")                                                            \
  ROLE(base_normal, 3, "the geometric normal, or that before a bump map")                          \
  ROLE(tangent, 3, "dp/du, for normals in the surface's own frame")                                \
  ROLE(depth, 1, "distance to the viewer, along the camera's axis or the ray")                     \
  ROLE(coverage, 1, "alpha: the share of the pixel that shows a surface")                          \
  ROLE(ids, 1, "a number for each object")                                                         \
  ROLE(primitive_ids, 1, "a number for each triangle")                                             \
  ROLE(uv, 2, "texture coordinates")                                                               \
  ROLE(glossiness, 1, "1 - roughness")                                                             \
  ROLE(diffuse_light, 3, "diffuse light times albedo: over diffuse_raw_light it gives the albedo") \
  ROLE(diffuse_raw_light, 3, "diffuse light before the albedo")

struct Role {
  std::string_view name;
  int components;
  std::string_view meaning;
};

/// Those of the list, then the parameters.
const std::vector<Role>& roles();

/// Null if there is none of that name.
const Role* find_role(std::string_view name);

}  // namespace relume
