// V-Ray: cameraTransform (camera to world) and cameraFov. The host program decides what the local axes are, and the file does not name it
// (research: exr-conventions B.3): 3ds Max's are right, up, backward in a z-up world, Maya's right, backward, down in a y-up one.
#include <ImfChannelList.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "gbuffer/camera_header.h"
#include "gbuffer/cameras/field_of_view.h"
#include "gbuffer/cameras/header_values.h"
#include "gbuffer/cameras/projection.h"

namespace relume {
namespace {

/// A host's reading of the local axes, and what speaks for it.
struct Host {
  const char *name, *axes;
  glm::dvec3 world_up;
  std::array<const char*, 3> scene_files;  ///< words in a vrayInfo text
  bool vray_channels;                      ///< names its elements VRayNormals, VRayZDepth, ...; else normals, diffuse, ...
  glm::dvec3 right, up, backward;
  double score = 0;
  std::string evidence;

  void support(double weight, const std::string& why) {
    score += weight;
    evidence += (evidence.empty() ? "" : ", ") + why;
  }
};

/// Nobody tilts a camera sideways by accident: level about the world's up axis, and the right way up.
bool level(const Host& host, const glm::dvec3& world_up) {
  return std::abs(glm::dot(glm::normalize(host.right), world_up)) < 1e-3 && glm::dot(host.up, world_up) > 0;
}

std::string info_texts(const HeaderValues& values) {
  std::string texts;
  for (const std::string& name : values.names("vrayInfo/", "")) texts += values.text(name) + ' ';
  for (char& c : texts)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  return texts;
}

bool has_vray_channels(const HeaderValues& values) {
  const Imf::ChannelList& channels = values.header().channels();
  for (auto i = channels.begin(); i != channels.end(); ++i)
    if (std::string(i.name()).starts_with("VRay")) return true;
  return false;
}

void weigh(Host& host, const HeaderValues& values, const glm::dvec3& eye) {
  const std::string texts = info_texts(values);
  const bool named =
      std::any_of(host.scene_files.begin(), host.scene_files.end(), [&](const char* word) { return texts.find(word) != std::string::npos; });
  if (named) host.support(8, "vrayInfo names it");
  const glm::dvec3 y_up(0, 1, 0), z_up(0, 0, 1);
  if (level(host, host.world_up))
    host.support(2, "level in its world");
  else if (level(host, host.world_up == y_up ? z_up : y_up))
    host.support(1, "level");
  if (has_vray_channels(values) == host.vray_channels) host.support(1, "its channel names");
  if (glm::dot(eye, host.backward) > 0) host.support(0.5, "faces the origin");  // where scenes are built; it breaks ties only
}

/// The matrix; OpenImageIO writes V-Ray's under the name worldToCamera.
std::optional<std::vector<double>> stored_transform(const HeaderValues& values) {
  if (const auto stored = values.numbers("cameraTransform", 16)) return stored;
  const bool is_vray = values.has("cameraAperture") || values.has("cameraTargetDistance") || !values.names("vrayInfo/", "").empty();
  return is_vray ? values.numbers("worldToCamera", 16) : std::nullopt;
}

std::optional<Lens> lens_of(const HeaderValues& values, const Window& display) {
  if (values.number("cameraProjection").value_or(0) != 0) return {};  // 0 is the ordinary camera; the others bend or flatten the image
  return stated_lens(values, display);
}

std::vector<Camera> read(const HeaderValues& values, const Window& display) {
  const auto stored = stored_transform(values);
  if (!stored) return {};
  const glm::dmat4 matrix = matrix_of(*stored, false);
  if (!rigid(matrix)) return {};
  const glm::dvec3 x(matrix[0]), y(matrix[1]), z(matrix[2]), eye(matrix[3]);
  std::vector<Host> hosts{
      {"3ds Max", "right, up, backward", {0, 0, 1}, {".max", "3dsmax", "3ds max"}, true, x, y, z, 0, {}},
      {"Maya", "right, backward, down", {0, 1, 0}, {".ma ", ".mb ", "maya"}, false, x, -z, y, 0, {}},
  };
  for (Host& host : hosts) weigh(host, values, eye);
  std::stable_sort(hosts.begin(), hosts.end(), [](const Host& a, const Host& b) { return a.score > b.score; });
  std::vector<Camera> cameras;
  for (const Host& host : hosts) {
    Camera camera;
    camera.world_from_camera = pose_of(host.right, host.up, host.backward, eye);
    set_lens(camera, lens_of(values, display), display);
    camera.source = std::string("cameraTransform of the header, its axes read as ") + host.name + "'s (" + host.axes +
                    (host.evidence.empty() ? "" : ": " + host.evidence) + ")";
    cameras.push_back(camera);
  }
  return cameras;
}

}  // namespace

extern const HeaderCamera header_camera_vray;
const HeaderCamera header_camera_vray{"vray", "cameraTransform and cameraFov", "exr-conventions B.3, measured on V-Ray for Maya 3.60", read};

}  // namespace relume
