// Means weighted by angle (Thuermer and Wuethrich 1998, "Computing Vertex Normals from Polygonal Facets"): they do not depend on how a face is cut
// into triangles.
#include "bake/vertex_normals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

namespace relume {
namespace {

/// An object's vertices at one place, whatever else tells them apart.
using Place = std::array<double, 4>;

Place place_of(const Mesh& mesh, const MeshTriangle& triangle, int k) {
  const glm::dvec3& p = mesh.corner(triangle, k);
  return {p.x + 0.0, p.y + 0.0, p.z + 0.0, double(triangle.object)};  // + 0: -0 and 0 are one place
}

double angle_at(const Mesh& mesh, const MeshTriangle& triangle, int k) {
  const glm::dvec3 &at = mesh.corner(triangle, k), a = mesh.corner(triangle, (k + 1) % 3) - at, b = mesh.corner(triangle, (k + 2) % 3) - at;
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

bool is_direction(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && glm::length(v) > 0; }

}  // namespace

void make_smooth_normals(Mesh& mesh) {
  std::map<Place, glm::dvec3> sums;
  for (const MeshTriangle& triangle : mesh.triangles)
    for (int k = 0; k < 3; ++k)
      sums.try_emplace(place_of(mesh, triangle, k), 0).first->second += angle_at(mesh, triangle, k) * glm::normalize(area_normal(mesh, triangle));
  for (const MeshTriangle& triangle : mesh.triangles)
    for (int k = 0; k < 3; ++k) mesh.vertices[triangle.vertices[std::size_t(k)]].normal = sums.at(place_of(mesh, triangle, k));
  mend_normals(mesh);
}

void make_flat_normals(Mesh& mesh) {
  std::vector<MeshVertex> own;
  own.reserve(3 * mesh.triangles.size());
  for (MeshTriangle& triangle : mesh.triangles) {
    const glm::dvec3 normal = glm::normalize(area_normal(mesh, triangle));
    for (std::uint32_t& vertex : triangle.vertices) {
      own.push_back(mesh.vertices[vertex]);
      own.back().normal = normal;
      vertex = std::uint32_t(own.size() - 1);
    }
  }
  mesh.vertices = std::move(own);
}

std::size_t mend_normals(Mesh& mesh) {
  for (MeshVertex& vertex : mesh.vertices) vertex.normal = is_direction(vertex.normal) ? glm::normalize(vertex.normal) : glm::dvec3(0);
  std::size_t mended = 0;
  for (const MeshTriangle& triangle : mesh.triangles)
    for (const std::uint32_t v : triangle.vertices) {
      glm::dvec3& normal = mesh.vertices[v].normal;
      if (normal != glm::dvec3(0)) continue;
      normal = glm::normalize(area_normal(mesh, triangle));
      ++mended;
    }
  return mended;
}

}  // namespace relume
