// turn_to_viewer: the first side that uses a vertex keeps it, the other gets a copy.
#include "bake/turn_to_viewer.h"

#include <utility>

namespace relume {
namespace {

enum class Side : char { unused, front, back };

/// The vertex as the triangles of one side see it.
class SidedVertices {
 public:
  explicit SidedVertices(Mesh& mesh) : mesh_(mesh), sides_(mesh.vertices.size(), Side::unused), others_(mesh.vertices.size(), 0) {}

  std::uint32_t seen_from(Side side, std::uint32_t vertex) {
    if (sides_[vertex] == Side::unused) {
      sides_[vertex] = side;
      if (side == Side::back) mesh_.vertices[vertex].normal *= -1.0;
    }
    if (sides_[vertex] == side) return vertex;
    if (others_[vertex] == 0) {  // a copy is never the first vertex
      others_[vertex] = std::uint32_t(mesh_.vertices.size());
      MeshVertex copy = mesh_.vertices[vertex];
      copy.normal *= -1.0;
      mesh_.vertices.push_back(copy);
    }
    return others_[vertex];
  }

 private:
  Mesh& mesh_;
  std::vector<Side> sides_;
  std::vector<std::uint32_t> others_;
};

}  // namespace

void turn_to_viewer(Mesh& mesh, const ViewingRays& rays) {
  SidedVertices vertices(mesh);
  for (MeshTriangle& triangle : mesh.triangles) {
    const Side side = rays.sees(mesh.corner(triangle, 0), area_normal(mesh, triangle)) ? Side::front : Side::back;
    for (std::uint32_t& vertex : triangle.vertices) vertex = vertices.seen_from(side, vertex);
    if (side == Side::back) std::swap(triangle.vertices[1], triangle.vertices[2]);
  }
}

}  // namespace relume
