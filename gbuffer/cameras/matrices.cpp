// worldToCamera, worldToNDC and worldToScreen: OpenEXR's own attributes and what writers make of them (research: exr-conventions B.1-B.4).
#include <algorithm>

#include "gbuffer/camera_header.h"
#include "gbuffer/cameras/field_of_view.h"
#include "gbuffer/cameras/header_values.h"
#include "gbuffer/cameras/projection.h"

namespace relume {
namespace {

struct Candidate {
  int rank;  ///< 0: pose and projection agree
  Camera camera;
};

struct Matrices {
  const HeaderValues& values;
  const Window& display;
  std::string projection_name;
  std::optional<std::vector<double>> projection;
  std::vector<Candidate> candidates;

  void add(int rank, Camera camera, const std::string& source, bool transposed) {
    camera.source = source + (transposed ? ", stored transposed" : "");
    candidates.push_back({rank, std::move(camera)});
  }
};

/// `z_forward`: the attribute's camera looks along +z, as OpenEXR says, where ours looks along -z.
Camera posed(const glm::dmat4& world_from_attribute, bool z_forward) {
  Camera camera;
  camera.world_from_camera = pose_of(glm::dvec3(world_from_attribute[0]), glm::dvec3(world_from_attribute[1]),
                                     glm::dvec3(world_from_attribute[2]) * (z_forward ? -1.0 : 1.0), glm::dvec3(world_from_attribute[3]));
  return camera;
}

void add_poses(Matrices& m, const glm::dmat4& matrix, bool transposed) {
  if (!rigid(matrix)) return;
  Camera camera = posed(glm::inverse(matrix), true);
  const std::string source = "worldToCamera of the header";
  if (m.projection && add_projection(camera, matrix_of(*m.projection, transposed), m.display, m.values.pixel_aspect()))
    return m.add(0, camera, source + " with " + m.projection_name, transposed);
  set_lens(camera, stated_lens(m.values, m.display), m.display);
  m.add(m.projection ? 3 : 2, camera, source, transposed);
  // What else writers have put there: OpenGL's view matrix, and the camera's own transform (OpenImageIO renames V-Ray's to worldToCamera).
  for (const bool inverse : {false, true})
    for (const bool z_forward : {false, true}) {
      if (!inverse && z_forward) continue;
      Camera other = posed(inverse ? matrix : glm::inverse(matrix), z_forward);
      set_lens(other, stated_lens(m.values, m.display), m.display);
      const std::string axes = z_forward ? " (z forward)" : " (z backward)";
      m.add(4, other, source + (inverse ? ", read as camera to world" : "") + axes, transposed);
    }
}

std::vector<Camera> read(const HeaderValues& values, const Window& display) {
  Matrices m{values, display, {}, {}, {}};
  for (const char* name : {"worldToNDC", "worldToScreen"})
    if (!m.projection) {
      m.projection = values.numbers(name, 16);
      m.projection_name = name;
    }
  const auto pose = values.numbers("worldToCamera", 16);
  for (const bool transposed : {false, true}) {
    if (pose) add_poses(m, matrix_of(*pose, transposed), transposed);
    if (!m.projection) continue;
    for (const Camera& camera : cameras_of_projection(matrix_of(*m.projection, transposed), display, values.pixel_aspect()))
      m.add(1, camera, m.projection_name + " of the header", transposed);
  }
  std::stable_sort(m.candidates.begin(), m.candidates.end(), [](const Candidate& a, const Candidate& b) { return a.rank < b.rank; });
  std::vector<Camera> cameras;
  for (Candidate& candidate : m.candidates) cameras.push_back(std::move(candidate.camera));
  return cameras;
}

}  // namespace

extern const HeaderCamera header_camera_matrices;
const HeaderCamera header_camera_matrices{"matrices", "worldToCamera, worldToNDC, worldToScreen", "OpenEXR's StandardAttributes; exr-conventions B",
                                          read};

}  // namespace relume
