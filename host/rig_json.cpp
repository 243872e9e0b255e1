// The rig file of FORMATS.md: lights and camera, each key checked.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include "host/json.h"
#include "host/lobes.h"
#include "host/rig_readers.h"

namespace relume {
namespace {

const std::vector<std::string_view> common_keys = {"type", "name", "group", "enabled", "exposure", "include", "exclude"};
const std::vector<std::string_view> later_types = {"rect", "disk", "sphere"};

glm::dvec3 vector_of(const std::vector<double>& v) { return {v[0], v[1], v[2]}; }

std::vector<std::string_view> known_types() { return names_of(all_light_types()); }

std::vector<std::string_view> keys_of(const std::string& type) {
  std::vector<std::string_view> keys = common_keys;
  const std::vector<std::string_view> own = term_named(all_light_types(), type, "light type").parameters;
  keys.insert(keys.end(), own.begin(), own.end());
  return keys;
}

LightType type_of(const std::string& name) { return LightType(term_named(all_light_types(), name, "light type").number); }

/// Whether the type has a key in its list; what has it, needs it.
bool takes(const Light& light, std::string_view key) {
  const std::vector<std::string_view> keys = all_light_types()[std::size_t(light.type)].parameters;
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

void read_place(const ObjectReader& reader, Light& light) {
  if (takes(light, "position")) {
    reader.need("position");
    light.position = vector_of(*reader.numbers("position", 3));
  }
  if (takes(light, "direction")) {
    reader.need("direction");
    light.direction = unit_or_zero(vector_of(*reader.numbers("direction", 3)));
    if (light.direction == glm::dvec3(0)) reader.fail("direction", "must not be zero");
  }
}

void read_strength(const ObjectReader& reader, Light& light) {
  const double factor = std::exp2(reader.number("exposure").value_or(0));
  if (light.type == LightType::ambient && reader.has("fraction")) {
    if (reader.has("intensity")) reader.fail("fraction", "stands instead of \"intensity\" (give one of them)");
    light.fraction = *reader.number("fraction") * factor;
    if (*light.fraction < 0) reader.fail("fraction", "must not be negative");
    return;
  }
  reader.need("intensity");
  light.intensity = vector_of(*reader.numbers("intensity", 3, true)) * factor;
  const bool negative = light.intensity.x < 0 || light.intensity.y < 0 || light.intensity.z < 0;
  if (light.type == LightType::environment && negative) reader.fail("intensity", "must not be negative");
}

void read_falloff(const ObjectReader& reader, Light& light) {
  const bool ranged = reader.has("range");
  light.range = reader.number("range").value_or(0);
  if (ranged && light.range <= 0) reader.fail("range", "must be above 0");
  const auto given = reader.choice("falloff", {"inverse_square", "windowed", "linear", "none"});
  light.falloff = given ? static_cast<Falloff>(*given) : ranged ? Falloff::windowed : Falloff::inverse_square;
  const bool takes_range = light.falloff == Falloff::windowed || light.falloff == Falloff::linear;
  if (takes_range && !ranged) reader.fail("falloff", "needs \"range\"");
  if (!takes_range && ranged) reader.fail("range", "has no meaning for this \"falloff\" (windowed and linear have one)");
  if (reader.has("range_begin") && light.falloff != Falloff::linear) reader.fail("range_begin", "is for \"falloff\": \"linear\" alone");
  light.range_begin = reader.number("range_begin").value_or(0);
  if (light.range_begin < 0) reader.fail("range_begin", "must not be negative");
  if (light.falloff == Falloff::linear && light.range_begin >= light.range) reader.fail("range_begin", "must be below \"range\"");
}

void read_cone(const ObjectReader& reader, Light& light) {
  light.inner_angle = reader.number("inner_angle").value_or(light.inner_angle);
  light.outer_angle = reader.number("outer_angle").value_or(light.outer_angle);
  if (light.outer_angle < 0 || light.outer_angle > 90) reader.fail("outer_angle", "must be in 0..90 degrees, from the axis to the rim");
  if (light.inner_angle < 0 || light.inner_angle > light.outer_angle)
    reader.fail("inner_angle", "must lie between 0 and \"outer_angle\" (" + in_digits(light.outer_angle) + " degrees)");
  light.cone = static_cast<Cone>(reader.choice("cone", {"gltf", "smoothstep", "linear"}).value_or(0));
}

/// Names or numbers of objects: in a Cryptomatte names, elsewhere ids.
std::vector<std::string> read_objects(const ObjectReader& reader, std::string_view key) {
  const Json* list = reader.json().find(key);
  if (!list) return {};
  if (list->type != Json::Type::array || list->items.empty()) reader.fail(key, "must be an array of at least one object's name or id");
  std::vector<std::string> objects;
  for (const Json& item : list->items) {
    const bool id = item.type == Json::Type::number && item.number >= 0 && item.number <= 4294967295.0 && item.number == std::floor(item.number);
    if (!id && (item.type != Json::Type::string || item.string.empty()))
      reader.fail(item.line, in_quotes(key) + ": must be objects' names or ids (0..4294967295)");
    objects.push_back(id ? std::to_string(std::uint32_t(item.number)) : item.string);
  }
  return objects;
}

void read_links(const ObjectReader& reader, Light& light) {
  light.include = read_objects(reader, "include");
  light.exclude = read_objects(reader, "exclude");
  if (!light.include.empty() && !light.exclude.empty()) reader.fail("exclude", "stands instead of \"include\" (give one of them)");
}

/// Whether the matrix takes unit vectors at right angles to such: a rotation, or one and a mirror. 1e-3 lets matrices through that were typed with
/// three digits.
bool is_rigid(const glm::dmat3& m) {
  const glm::dmat3 product = glm::transpose(m) * m;
  double error = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) error = std::max(error, std::abs(product[i][j] - (i == j)));
  return error <= 1e-3;
}

/// How the image's axes lie in the world.
void read_orientation(const ObjectReader& reader, Light& light) {
  if (const auto rows = reader.numbers("world_from_light", 9)) {
    if (reader.has("rotation")) reader.fail("rotation", "stands instead of \"world_from_light\" (give one of them)");
    light.world_from_light = glm::transpose(glm::make_mat3(rows->data()));
    if (!is_rigid(light.world_from_light))
      reader.fail("world_from_light", "must be a rotation: unit vectors at right angles (9 numbers, row by row)");
  }
  if (const auto degrees = reader.number("rotation"))
    light.world_from_light = glm::dmat3(glm::rotate(glm::dmat4(1.0), glm::radians(std::fmod(*degrees, 360.0)), light.mapping->up()));
}

void read_image(const ObjectReader& reader, const std::filesystem::path& folder, Light& light) {
  reader.need("texture");
  const std::string name = *reader.string("texture");
  if (name.empty()) reader.fail("texture", "must name a file");
  light.texture = folder / name;
  std::vector<std::string_view> names;
  for (const EnvironmentMapping& mapping : environment_mappings()) names.push_back(mapping.name);
  light.mapping = &environment_mappings()[reader.choice("mapping", names).value_or(0)];
  read_orientation(reader, light);
}

/// Empty where the light is switched off.
std::optional<Light> read_light(const ObjectReader& reader, const std::filesystem::path& folder, std::size_t index) {
  reader.need("type");
  const std::string type = *reader.string("type");
  const bool enabled = reader.boolean("enabled").value_or(true);
  if (std::find(later_types.begin(), later_types.end(), type) != later_types.end()) {
    if (!enabled) return {};
    reader.fail("type", in_quotes(type) + " is not supported yet (has: " + listed(known_types()) + ")");
  }
  reader.choice("type", known_types());
  reader.allow(keys_of(type));
  Light light;
  light.type = type_of(type);
  light.name = reader.string("name").value_or(type + std::to_string(index));
  light.group = reader.string("group").value_or("");
  read_place(reader, light);
  if (takes(light, "texture")) read_image(reader, folder, light);
  read_strength(reader, light);
  if (takes(light, "falloff")) read_falloff(reader, light);
  if (takes(light, "cone")) read_cone(reader, light);
  read_links(reader, light);
  const std::string too_large = beyond_single(light);
  if (!too_large.empty()) reader.fail(too_large, "is beyond single precision");
  return enabled ? std::optional(light) : std::nullopt;
}

/// A rotation, or one and a mirror, and a place.
void check_rigid(const ObjectReader& reader, const glm::dmat4& m) {
  if (!is_rigid(glm::dmat3(m))) reader.fail("world_from_camera", "must be a rigid motion: its first three columns unit vectors at right angles");
  const glm::dvec4 last = glm::transpose(m)[3];
  if (last != glm::dvec4(0, 0, 0, 1)) reader.fail("world_from_camera", "its last row must be 0, 0, 0, 1 (16 numbers, row by row)");
}

Camera read_camera(const ObjectReader& reader, const std::string& file) {
  Camera camera;
  camera.source = file;
  const bool orthographic = reader.choice("type", {"perspective", "orthographic"}).value_or(0) == 1;
  camera.projection = orthographic ? Camera::Projection::orthographic : Camera::Projection::perspective;
  const std::string_view size = orthographic ? "height" : "vertical_fov";
  reader.allow({"type", "world_from_camera", size});
  reader.need("world_from_camera");
  const std::vector<double> rows = *reader.numbers("world_from_camera", 16);
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) camera.world_from_camera[column][row] = rows[4 * row + column];
  check_rigid(reader, camera.world_from_camera);
  if (const auto value = reader.number(size)) {
    if (*value <= 0 || (!orthographic && *value >= 180))
      reader.fail(size, orthographic ? "must be above 0 (world units)" : "must lie between 0 and 180 degrees");
    (orthographic ? camera.height : camera.vertical_fov) = *value;
  }
  return camera;
}

}  // namespace

Rig read_json_rig(const Json& json, const std::string& file) {
  const ObjectReader top(json, file, "");
  top.allow({"relume", "camera", "ids", "lights"});
  top.need_version();
  Rig rig;
  if (const Json* camera = json.find("camera")) rig.camera = read_camera(ObjectReader(*camera, file, "camera"), file);
  const std::string ids = top.string("ids").value_or("");
  const Json* lights = json.find("lights");
  if (!lights) return rig;
  if (lights->type != Json::Type::array) top.fail("lights", "must be an array");
  for (std::size_t i = 0; i < lights->items.size(); ++i) {
    const ObjectReader reader(lights->items[i], file, "lights[" + std::to_string(i) + "]");
    std::optional<Light> light = read_light(reader, std::filesystem::path(file).parent_path(), i);
    if (!light) continue;
    light->ids = ids;
    rig.lights.push_back(std::move(*light));
  }
  return rig;
}

}  // namespace relume
