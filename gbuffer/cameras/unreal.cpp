// Unreal's Movie Render Queue: the camera as texts in centimetres and degrees, left-handed with z up (research: exr-conventions A.8, B.3; the
// rotation is UE's FRotationMatrix; what the field of view spans, MoviePipelineImagePassBase.cpp).
#include <cmath>
#include <glm/trigonometric.hpp>

#include "gbuffer/camera_header.h"
#include "gbuffer/cameras/field_of_view.h"
#include "gbuffer/cameras/header_values.h"
#include "gbuffer/cameras/projection.h"

namespace relume {
namespace {

/// x forward, y right, z up, turned by pitch, yaw and roll.
glm::dmat4 pose_of_rotator(double pitch, double yaw, double roll, const glm::dvec3& eye) {
  const double sp = std::sin(pitch), cp = std::cos(pitch), sy = std::sin(yaw), cy = std::cos(yaw), sr = std::sin(roll), cr = std::cos(roll);
  const glm::dvec3 forward(cp * cy, cp * sy, sp), right(sr * sp * cy - cr * sy, sr * sp * sy + cr * cy, -sr * cp),
      up(-(cr * sp * cy + sr * sy), cy * sr - cr * sp * sy, cr * cp);
  return pose_of(right, up, -forward, eye);
}

/// A pass's own value, the final image's first: "unreal/camera/FinalImage/fov".
std::optional<double> of_pass(const HeaderValues& values, const std::string& what) {
  if (const auto number = values.number("unreal/camera/FinalImage/" + what)) return number;
  for (const std::string& name : values.names("unreal/camera/", "/" + what))
    if (const auto number = values.number(name)) return number;
  return {};
}

/// The field of view takes in the overscan, which the display window leaves out where the data window reaches beyond it.
std::optional<Lens> lens_of_pass(const HeaderValues& values, const Window& display) {
  const Imath::Box2i& data = values.header().dataWindow();
  const double overscan = of_pass(values, "overscanPercent").value_or(0);  // a share, despite its name
  const bool beyond = data.min.x < display.min_x || data.max.x >= display.max_x;
  const double spanned = beyond && overscan > 0 && overscan < 10 ? 1 + overscan : 1;
  if (const auto degrees = of_pass(values, "fov"); degrees && *degrees > 0 && *degrees < 180)
    return lens_of_width(2 * std::tan(glm::radians(*degrees) / 2) / spanned, display, values.pixel_aspect());
  const double focal = of_pass(values, "focalLength").value_or(0), film = of_pass(values, "sensorWidth").value_or(0);
  return lens_of_width(focal > 0 ? film / focal : 0, display, values.pixel_aspect());
}

std::vector<Camera> read(const HeaderValues& values, const Window& display) {
  const auto place = [&](const char* axis) { return values.number(std::string("unreal/camera/curPos/") + axis); };
  const auto turn = [&](const char* axis) { return glm::radians(values.number(std::string("unreal/camera/curRot/") + axis).value_or(0)); };
  const auto x = place("x"), y = place("y"), z = place("z");
  if (!x || !y || !z) return {};
  Camera camera;
  camera.world_from_camera = pose_of_rotator(turn("pitch"), turn("yaw"), turn("roll"), {*x, *y, *z});
  set_lens(camera, lens_of_pass(values, display), display);
  camera.source = "unreal/camera of the header";
  return {camera};
}

}  // namespace

extern const HeaderCamera header_camera_unreal;
const HeaderCamera header_camera_unreal{"unreal", "unreal/camera/curPos, curRot and fov", "exr-conventions A.8; Unreal Engine's own source", read};

}  // namespace relume
