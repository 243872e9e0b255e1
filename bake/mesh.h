// A mesh as it is baked: triangles in one world, with normals at their vertices and what the file tells of their materials.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

#include "bake/mesh_texture.h"

namespace relume {

struct MeshVertex {
  glm::dvec3 position{0};  ///< world
  glm::dvec3 normal{0};    ///< world, unit length
  glm::vec2 uv{0};         ///< v counts upwards
  glm::vec3 colour{1};     ///< linear; multiplies the albedo
};

struct MeshTriangle {
  std::array<std::uint32_t, 3> vertices;  ///< counter-clockwise for who sees its front
  std::uint32_t object;                   ///< position in Mesh::objects
  std::uint32_t material;
};

/// A factor, and the texture that it multiplies, if there is one.
struct MeshColour {
  glm::dvec3 factor{1};
  std::shared_ptr<const MeshTexture> texture;
};

struct MeshMaterial {
  MeshColour albedo, roughness, metallic;  ///< numbers in .x; a texture's in the channel that `..._channel` says
  int roughness_channel = 0, metallic_channel = 0;
};

struct Mesh {
  std::vector<MeshVertex> vertices;
  std::vector<MeshTriangle> triangles;
  std::vector<MeshMaterial> materials;
  std::vector<std::string> objects;                                                      ///< names, as the file has them
  bool has_uv = false, has_albedo = false, has_roughness = false, has_metallic = false;  ///< whether the file tells any
  bool has_camera = false;                                                               ///< the file has one of its own
  std::vector<std::string> notes;                                                        ///< what was assumed or left out, a sentence each

  const glm::dvec3& corner(const MeshTriangle& triangle, int k) const { return vertices[triangle.vertices[std::size_t(k)]].position; }
};

/// Twice the triangle's area, along the normal of its front.
glm::dvec3 area_normal(const Mesh& mesh, const MeshTriangle& triangle);

/// The box around all vertices.
struct MeshBounds {
  glm::dvec3 lowest, highest;
  glm::dvec3 centre() const { return 0.5 * (lowest + highest); }
  double radius() const;  ///< of the ball around the box
};
MeshBounds bounds_of(const Mesh& mesh);

}  // namespace relume
