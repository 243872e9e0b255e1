// surface_at: weights times vertices (Phong 1975 for the normal), then the material's factors and textures.
#include "bake/surface_point.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace relume {
namespace {

glm::dvec3 value_of(const MeshColour& colour, const glm::dvec2& uv) {
  return colour.texture ? colour.factor * colour.texture->at(uv) : colour.factor;
}

double number_of(const MeshColour& number, int channel, const glm::dvec2& uv) {
  return glm::clamp(number.texture ? number.factor.x * number.texture->at(uv)[channel] : number.factor.x, 0.0, 1.0);
}

}  // namespace

SurfacePoint surface_at(const Mesh& mesh, const MeshTriangle& triangle, const glm::dvec3& barycentrics) {
  SurfacePoint point;
  glm::dvec3 colour(0);
  for (int k = 0; k < 3; ++k) {
    const MeshVertex& vertex = mesh.vertices[triangle.vertices[std::size_t(k)]];
    point.position += barycentrics[k] * vertex.position;
    point.normal += barycentrics[k] * vertex.normal;
    point.uv += barycentrics[k] * glm::dvec2(vertex.uv);
    colour += barycentrics[k] * glm::dvec3(vertex.colour);
  }
  point.geometric_normal = glm::normalize(area_normal(mesh, triangle));
  const double length = glm::length(point.normal);
  point.normal = length > 1e-6 ? point.normal / length : point.geometric_normal;  // opposite normals leave no direction between them
  const MeshMaterial& material = mesh.materials[triangle.material];
  point.albedo = glm::clamp(colour * value_of(material.albedo, point.uv), 0.0, 1.0);
  point.roughness = number_of(material.roughness, material.roughness_channel, point.uv);
  point.metallic = number_of(material.metallic, material.metallic_channel, point.uv);
  point.object = triangle.object + 1;
  return point;
}

}  // namespace relume
