// glTF as a rig: KHR_lights_punctual and cameras, with what Blender's exporter means by them (research: blender-truth, "glTF rig written by
// Blender").
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "gbuffer/error.h"
#include "host/gltf_scene.h"
#include "host/rig_readers.h"

namespace relume {
namespace {

constexpr double lumens_per_watt = 683;  // Blender's exporter in its mode SPEC: the efficacy at 555 nm for every colour

[[noreturn]] void fail(const std::string& file, const std::string& what) { throw Error(ErrorKind::input, file + ": " + what); }

/// The choices that a glTF does not record, each from the option or from what its exporter does by default.
class Conventions {
 public:
  Conventions(const tinygltf::Model& model, const RigOptions& options, Rig& rig);

  /// W/sr or W/m^2 for the file's candela, lux or watts.
  double per_unit(LightType type) const;
  bool from_blender() const { return blender_; }
  bool obeys_range() const { return obeys_range_; }
  glm::dmat4 world_from_gltf() const {
    if (!turns_) return glm::dmat4(1);
    return {{1, 0, 0, 0}, {0, 0, 1, 0}, {0, -1, 0, 0}, {0, 0, 0, 1}};  // columns: (x, y, z) becomes (x, -z, y)
  }

 private:
  bool blender_, obeys_range_, turns_;
  RigOptions::Units units_;
};

Conventions::Conventions(const tinygltf::Model& model, const RigOptions& options, Rig& rig)
    : blender_(model.asset.generator.find("Blender") != std::string::npos),
      obeys_range_(options.obey_range.value_or(!blender_)),
      turns_(options.world_is_z_up && (options.up ? *options.up == RigOptions::Up::y : blender_)),
      units_(options.units.value_or(blender_ ? RigOptions::Units::spec : RigOptions::Units::compat)) {
  const std::string exporter = blender_ ? "the default of Blender's exporter" : "the glTF standard's";
  if (!options.units && !model.lights.empty())
    rig.notes.push_back(blender_ ? "units: SPEC (683 lm/W), " + exporter + "; --rig-units compat|raw says otherwise"
                                 : "units: candela and lux taken as W/sr and W/m^2; --rig-units spec divides by 683 lm/W");
  rig.axes_open = !options.up;
  rig.scale_open = !options.scale;
  if (options.world_is_z_up && !options.up)
    rig.assumed_axes = blender_
                           ? "axes: y up turned to the G-buffer's z up, the default of Blender's exporter; --rig-up z says that the file has z up"
                           : "axes: taken as they are, although the G-buffer's world has z up; --rig-up y turns the rig";
  else if (!options.up)
    rig.assumed_axes = "axes and unit: taken to be the G-buffer's own; --rig-up and --rig-scale say otherwise";
  const bool ranged = std::any_of(model.lights.begin(), model.lights.end(), [](const tinygltf::Light& light) { return light.range > 0; });
  if (ranged && !options.obey_range)
    rig.notes.push_back(blender_ ? "ranges: ignored, as Cycles does; --rig-range obey says otherwise"
                                 : "ranges: obeyed with glTF's window; --rig-range ignore says otherwise");
}

double Conventions::per_unit(LightType type) const {
  if (units_ == RigOptions::Units::spec) return 1 / lumens_per_watt;
  const bool power = units_ == RigOptions::Units::raw && type != LightType::directional;  // RAW: Blender's watts, sent evenly over the sphere
  return power ? 1 / (4 * std::numbers::pi) : 1;
}

/// Between the rims, Cycles falls smoothly over a share `blend` of the cosine from rim to axis; the exporter keeps that share as one of angles.
void set_cone(Light& light, const tinygltf::SpotLight& spot, bool from_blender) {
  const double outer = std::min(spot.outerConeAngle, std::numbers::pi / 2);
  light.outer_angle = glm::degrees(outer);
  light.inner_angle = std::min(glm::degrees(spot.innerConeAngle), light.outer_angle);
  if (!from_blender) return;
  light.cone = Cone::smoothstep;
  const double blend = outer > 0 ? std::max(1 - spot.innerConeAngle / outer, 0.0) : 0;
  const double rim = std::cos(outer);
  if (blend > 0) light.inner_angle = glm::degrees(std::acos(std::min(rim + (1 - rim) * blend, 1.0)));
}

Light light_from(const tinygltf::Light& source, const Placed& placed, const Conventions& conventions, const std::string& file) {
  const std::string where = "light " + in_quotes(placed.name) + ": ";
  Light light;
  if (source.type == "point")
    light.type = LightType::point;
  else if (source.type == "spot")
    light.type = LightType::spot;
  else if (source.type == "directional")
    light.type = LightType::directional;
  else
    fail(file, where + "no glTF light type " + in_quotes(source.type) + " (has: directional, point, spot)");
  light.name = placed.name;
  const glm::dmat4 world_from_light = conventions.world_from_gltf() * placed.world_from_node;
  light.position = glm::dvec3(world_from_light[3]);
  if (light.type != LightType::point) {
    light.direction = unit_or_zero(-glm::dvec3(world_from_light[2]));
    if (light.direction == glm::dvec3(0)) fail(file, where + "its node is scaled to nothing, so it has no direction");
  }
  const glm::dvec3 color = source.color.size() == 3 ? glm::dvec3(source.color[0], source.color[1], source.color[2]) : glm::dvec3(1);
  light.intensity = color * source.intensity * conventions.per_unit(light.type);  // a colour temperature takes `color` above 1
  if (source.range > 0 && conventions.obeys_range() && light.type != LightType::directional) {
    light.falloff = Falloff::windowed;
    light.range = source.range;
  }
  if (light.type == LightType::spot) set_cone(light, source.spot, conventions.from_blender());
  const std::string too_large = beyond_single(light);
  if (!too_large.empty()) fail(file, where + in_quotes(too_large) + " is beyond single precision");
  return light;
}

/// The node's axes at right angles and of unit length: a camera is not scaled.
glm::dmat4 rigid(const glm::dmat4& matrix, const std::string& where, const std::string& file) {
  const glm::dvec3 backward = unit_or_zero(glm::dvec3(matrix[2]));
  const glm::dvec3 right = unit_or_zero(glm::dvec3(matrix[0]) - backward * glm::dot(backward, glm::dvec3(matrix[0])));
  if (backward == glm::dvec3(0) || right == glm::dvec3(0)) fail(file, where + "its node is scaled to nothing, so it has no direction");
  if (!std::isfinite(glm::dot(backward + right, glm::dvec3(1)) + matrix[3].x + matrix[3].y + matrix[3].z))
    fail(file, where + "its place is not finite");
  const double side = glm::determinant(glm::dmat3(matrix)) < 0 ? -1 : 1;
  return {glm::dvec4(right, 0), glm::dvec4(side * glm::cross(backward, right), 0), glm::dvec4(backward, 0), matrix[3]};
}

Camera camera_from(const tinygltf::Camera& source, const Placed& placed, const Conventions& conventions, const std::string& file) {
  Camera camera;
  camera.source = file;
  camera.world_from_camera = conventions.world_from_gltf() * rigid(placed.world_from_node, "camera " + in_quotes(placed.name) + ": ", file);
  if (source.type == "orthographic") {
    camera.projection = Camera::Projection::orthographic;
    camera.height = 2 * source.orthographic.ymag;  // ymag is half of what is seen
  } else {
    camera.vertical_fov = glm::degrees(source.perspective.yfov);
  }
  return camera;
}

}  // namespace

Rig read_gltf_rig(const Json& json, std::string_view text, const std::string& file, const RigOptions& options) {
  const GltfScene scene = read_gltf_scene(json, text, file);
  const tinygltf::Model& model = scene.model;
  if (scene.lights.empty() && scene.cameras.empty())
    fail(file, "glTF: neither a light nor a camera in its scene (lights are in KHR_lights_punctual)");
  Rig rig;
  const Conventions conventions(model, options, rig);
  for (const Placed& placed : scene.lights) rig.lights.push_back(light_from(model.lights[placed.index], placed, conventions, file));
  if (!scene.cameras.empty()) rig.camera = camera_from(model.cameras[scene.cameras[0].index], scene.cameras[0], conventions, file);
  if (scene.cameras.size() > 1)
    rig.notes.push_back("camera: " + in_quotes(scene.cameras[0].name) + ", the first of " + std::to_string(scene.cameras.size()));
  if (json.find("animations")) rig.notes.push_back("animations: not played; every node stands where the file has it at rest");
  return rig;
}

}  // namespace relume
