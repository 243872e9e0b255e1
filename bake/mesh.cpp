// Mesh: its triangles' normals and its bounds.
#include "bake/mesh.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace relume {

glm::dvec3 area_normal(const Mesh& mesh, const MeshTriangle& triangle) {
  const glm::dvec3& a = mesh.corner(triangle, 0);
  return glm::cross(mesh.corner(triangle, 1) - a, mesh.corner(triangle, 2) - a);
}

double MeshBounds::radius() const { return 0.5 * glm::distance(lowest, highest); }

MeshBounds bounds_of(const Mesh& mesh) {
  MeshBounds bounds{glm::dvec3(std::numeric_limits<double>::infinity()), glm::dvec3(-std::numeric_limits<double>::infinity())};
  for (const MeshTriangle& triangle : mesh.triangles)  // vertices that no triangle uses are not seen
    for (int k = 0; k < 3; ++k) {
      bounds.lowest = glm::min(bounds.lowest, mesh.corner(triangle, k));
      bounds.highest = glm::max(bounds.highest, mesh.corner(triangle, k));
    }
  return bounds;
}

}  // namespace relume
