// sphere_mesh: vertices that triangles share are found by their place, which is the same sum for each of them.
#include "bake/sphere_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

namespace relume {
namespace {

/// Vertex numbers of the faces of an icosahedron with vertices (0, +-1, +-phi) and their rotations, counter-clockwise from outside.
constexpr std::array<std::array<int, 3>, 20> faces{{{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                                                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                                                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};

std::array<glm::dvec3, 12> icosahedron() {
  const double t = (1 + std::sqrt(5.0)) / 2;
  return {{{-1, t, 0},
           {1, t, 0},
           {-1, -t, 0},
           {1, -t, 0},
           {0, -1, t},
           {0, 1, t},
           {0, -1, -t},
           {0, 1, -t},
           {t, 0, -1},
           {t, 0, 1},
           {-t, 0, -1},
           {-t, 0, 1}}};
}

/// A point of a face: how many cuts from its other vertices each of the icosahedron's vertices is; those of weight 0 do not tell faces apart.
using Place = std::array<std::pair<int, int>, 3>;

class Sphere {
 public:
  explicit Sphere(int cuts) : cuts_(cuts) {}

  std::uint32_t vertex(const std::array<int, 3>& face, int i, int j) {
    Place place{{{cuts_ - i - j, face[0]}, {i, face[1]}, {j, face[2]}}};
    for (auto& [weight, corner] : place)
      if (weight == 0) corner = -1;
    std::sort(place.begin(), place.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    const auto [known, is_new] = known_.try_emplace(place, std::uint32_t(mesh.vertices.size()));
    if (!is_new) return known->second;
    glm::dvec3 sum(0);
    for (const auto& [weight, corner] : place)
      if (weight > 0) sum += double(weight) * corners_[std::size_t(corner)];
    MeshVertex v;
    v.position = v.normal = glm::normalize(sum);
    mesh.vertices.push_back(v);
    return known->second;
  }

  Mesh mesh;

 private:
  const int cuts_;
  const std::array<glm::dvec3, 12> corners_ = icosahedron();
  std::map<Place, std::uint32_t> known_;
};

}  // namespace

Mesh sphere_mesh(int cuts) {
  Sphere sphere(cuts);
  for (const std::array<int, 3>& face : faces)
    for (int i = 0; i < cuts; ++i)
      for (int j = 0; j < cuts - i; ++j) {
        const std::uint32_t a = sphere.vertex(face, i, j), b = sphere.vertex(face, i + 1, j), c = sphere.vertex(face, i, j + 1);
        sphere.mesh.triangles.push_back({{a, b, c}, 0, 0});
        if (j + 1 < cuts - i) sphere.mesh.triangles.push_back({{b, sphere.vertex(face, i + 1, j + 1), c}, 0, 0});
      }
  sphere.mesh.materials.resize(1);
  sphere.mesh.objects = {"sphere of " + std::to_string(sphere.mesh.triangles.size()) + " triangles"};
  return sphere.mesh;
}

double mean_edge(const Mesh& mesh) {
  double sum = 0;
  for (const MeshTriangle& triangle : mesh.triangles)
    for (int k = 0; k < 3; ++k) sum += glm::distance(mesh.corner(triangle, k), mesh.corner(triangle, (k + 1) % 3));
  return sum / (3 * double(mesh.triangles.size()));
}

}  // namespace relume
