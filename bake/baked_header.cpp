// The camera's matrices as OpenEXR's StandardAttributes mean them: for row vectors, a camera that looks along +z, NDC 0..1 with y down.
#include "bake/baked_header.h"

#include <ImfMatrixAttribute.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>

#include <glm/matrix.hpp>

#include "gbuffer/printable.h"

namespace relume {
namespace {

/// A matrix for column vectors; its columns are the rows of the one for row vectors.
Imath::M44f attribute_of(const glm::dmat4& m) {
  Imath::M44f stored;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) stored[i][j] = float(m[i][j]);
  return stored;
}

glm::dmat4 ndc_from_camera(const Camera& camera, const Lens& lens, const BakeJob& job) {
  const double across = lens.scale_x / job.width, down = -lens.scale_y / job.height, x = lens.centre_x / job.width, y = lens.centre_y / job.height;
  if (camera.projection == Camera::Projection::orthographic) return {{across, 0, 0, 0}, {0, down, 0, 0}, {0, 0, 1, 0}, {x, y, 0, 1}};
  constexpr double near = 0.01;  // where NDC's z is 0: a projection needs some plane, and nothing here depends on it
  return {{across, 0, 0, 0}, {0, down, 0, 0}, {x, y, 1, 1}, {0, 0, -near, 0}};
}

std::string names_of(const Mesh& mesh) {
  constexpr std::size_t enough = 1 << 14;  // bytes: headers are read whole, by every program that looks at the file
  std::string names;
  for (std::size_t i = 0; i < mesh.objects.size() && names.size() < enough; ++i)
    names += (i ? "\n" : "") + std::to_string(i + 1) + " " + printable(mesh.objects[i]);
  return names;
}

}  // namespace

Imf::Header header_of(const BakeJob& job, const Mesh& mesh) {
  glm::dmat4 world_from_camera = job.camera.world_from_camera;
  world_from_camera[2] *= -1.0;
  const glm::dmat4 camera_from_world = glm::inverse(world_from_camera);
  const Lens lens = *lens_of(job.camera, {0, 0, job.width, job.height}, 1);  // whoever made the rays has seen that there is one
  Imf::Header header;
  Imf::addWorldToCamera(header, attribute_of(camera_from_world));
  Imf::addWorldToNDC(header, attribute_of(ndc_from_camera(job.camera, lens, job) * camera_from_world));
  header.insert("software", Imf::StringAttribute("relume bake"));
  header.insert("relume:mesh", Imf::StringAttribute(job.mesh_name));
  header.insert("relume:objects", Imf::StringAttribute(names_of(mesh)));
  return header;
}

}  // namespace relume
