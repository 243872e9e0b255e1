// What a G-buffer stores of a point on a mesh.
#pragma once

#include "bake/mesh.h"

namespace relume {

struct SurfacePoint {
  glm::dvec3 position{0}, normal{0}, geometric_normal{0};
  glm::dvec2 uv{0};
  glm::dvec3 albedo{0};
  double roughness = 0, metallic = 0;
  std::uint32_t object = 0;  ///< number of the object, from 1
};

/// Interpolated between the triangle's vertices with these weights, normals brought back to unit length; textures looked up at the point.
SurfacePoint surface_at(const Mesh& mesh, const MeshTriangle& triangle, const glm::dvec3& barycentrics);

}  // namespace relume
