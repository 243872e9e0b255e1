// Lights and camera as a rig file states them (FORMATS: "The rig file"); angles in degrees, intensities radiometric per channel.
#pragma once

#include <filesystem>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "gbuffer/camera.h"
#include "host/environment_mapping.h"
#include "host/surrounding_lights.h"
#include "kernels/lights/list.h"

namespace relume {

#define RELUME_LIGHT_TYPE(name, ...) name,
/// The kernels' types, by their numbers (kernels/lights/list.h), then those from all around.
enum class LightType { RELUME_LIGHTS(RELUME_LIGHT_TYPE) RELUME_SURROUNDING_LIGHTS(RELUME_LIGHT_TYPE) };
#undef RELUME_LIGHT_TYPE
enum class Falloff { inverse_square, windowed, linear, none };
enum class Cone { gltf, smoothstep, linear };

struct Light {
  LightType type = LightType::point;
  std::string name;  ///< given, or "<type><index>"
  std::string group;
  glm::dvec3 position{0};          ///< world
  glm::dvec3 direction{0, 0, -1};  ///< the way the light travels, unit length
  glm::dvec3 intensity{
      0};  ///< W/sr (point, spot), W/m^2 (directional), W/(m^2 sr) (ambient, environment: times the texels); `exposure` is already multiplied in
  std::optional<double> fraction;               ///< ambient only: share of the frame's mean direct diffuse irradiance
  std::filesystem::path texture;                ///< environment only, as the next two: the image
  const EnvironmentMapping* mapping = nullptr;  ///< how the image is laid out
  glm::dmat3 world_from_light{1.0};             ///< turns the mapping's axes into the world's
  Falloff falloff = Falloff::inverse_square;
  double range_begin = 0, range = 0;  ///< world units; range 0 = unbounded
  Cone cone = Cone::gltf;
  double inner_angle = 0, outer_angle = 45;   ///< half-angles, degrees
  std::vector<std::string> include, exclude;  ///< objects, by name or number, that it lights alone, or does not light; one of the two at most
  std::string ids;                            ///< the layer that these are of; empty: the file's own (gbuffer/object_ids.h)
};

struct Rig {
  std::vector<Light> lights;  ///< enabled ones only
  std::optional<Camera> camera;
  std::vector<std::string> notes;  ///< what was assumed: units, ranges

  /// Whether its world is another's than the G-buffer's, so far as options do not tell: glTF's axes and units. Its camera settles it, against the
  /// one that saw the file (host/camera_choice.h).
  bool axes_open = false, scale_open = false;
  std::string assumed_axes;  ///< a note on what was taken meanwhile; empty where nothing was assumed
};

/// What a glTF rig does not say about itself (research: blender-truth). Unset: the default of the exporter that `asset.generator` names.
struct RigOptions {
  enum class Units { spec, compat, raw };
  enum class Up { y, z };
  std::optional<Units> units;
  std::optional<Up> up;
  std::optional<bool> obey_range;
  std::optional<double> scale;  ///< units of the G-buffer's world in one of the rig's: 100 for metres in a world of centimetres
  /// The G-buffer's world has z up (a Blender file): a y-up glTF is turned back to it.
  bool world_is_z_up = false;
  /// The renderer of the G-buffer. A Blender-exported spot keeps Cycles' cone whatever it is: the rim that the artist saw.
  std::string convention;
};

/// Reads JSON (strictly: unknown key, wrong type, not finite -> Error{input} naming file, line and key) or glTF/GLB, told apart by content.
/// "-" reads JSON from standard input.
Rig read_rig(const std::filesystem::path& file, const RigOptions& options);

/// Several, for a G-buffer of this renderer: options.convention and options.world_is_z_up follow from it.
std::vector<Rig> read_rigs(const std::vector<std::filesystem::path>& files, RigOptions options, const std::string& convention);

/// Lights of several rigs in order, camera of the first that has one.
Rig merge(std::vector<Rig> rigs);

}  // namespace relume
