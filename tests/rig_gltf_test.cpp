// glTF and GLB rigs: hierarchy, units, cones and axes as each exporter means them, and every refusal with its whole text.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "host/json.h"
#include "host/rig.h"
#include "tests/refusal.h"

namespace relume {
namespace {

/// Reads the content as standard input.
Rig read_string(const std::string& content, const RigOptions& options = {}) {
  const StandardInput input(content);
  return read_rig("-", options);
}

std::string rig_error(const std::string& content) {
  return error_of([&] { read_string(content); });
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double tolerance, const std::string& what) {
  EXPECT_LE(glm::length(a - b), tolerance * std::max(glm::length(b), 1e-300)) << what;
}

/// One light on a node, with what else the file has.
std::string gltf(const std::string& light, const std::string& generator = "by hand", const std::string& node = "", const std::string& more = "") {
  return "{\"asset\": {\"version\": \"2.0\", \"generator\": \"" + generator + "\"}, \"extensions\": {\"KHR_lights_punctual\": {\"lights\": [" +
         light + "]}}, \"scenes\": [{\"nodes\": [0]}], \"nodes\": [{" + node + (node.empty() ? "" : ", ") +
         "\"extensions\": {\"KHR_lights_punctual\": {\"light\": 0}}}]" + more + "}";
}

const std::string blender = "Khronos glTF Blender I/O v4.5.51";

Light only_light(const std::string& content, const RigOptions& options = {}) {
  const Rig rig = read_string(content, options);
  EXPECT_EQ(rig.lights.size(), 1u);
  return rig.lights.at(0);
}

std::string glb(const std::string& json) {
  const auto word = [](std::size_t value) {
    std::string bytes;
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i));
    return bytes;
  };
  return "glTF" + word(2) + word(20 + json.size()) + word(json.size()) + "JSON" + json;
}

TEST(Gltf, StandardUnitsAndWindowWhereNothingElseIsKnown) {
  const Light light = only_light(
      gltf(R"({"type": "spot", "intensity": 8, "color": [1.5, 0.5, 0], "range": 7, "spot": {"innerConeAngle": 0.1, "outerConeAngle": 0.5}})"));
  EXPECT_EQ(light.intensity, glm::dvec3(12, 4, 0));  // a colour above 1 is not clamped
  EXPECT_EQ(light.falloff, Falloff::windowed);
  EXPECT_EQ(light.range, 7);
  EXPECT_EQ(light.cone, Cone::gltf);
  EXPECT_NEAR(light.inner_angle, glm::degrees(0.1), 1e-12);
  EXPECT_NEAR(light.outer_angle, glm::degrees(0.5), 1e-12);
  EXPECT_EQ(light.direction, glm::dvec3(0, 0, -1));
  EXPECT_EQ(light.name, "spot0");
  RigOptions options;
  options.obey_range = false;
  EXPECT_EQ(only_light(gltf(R"({"type": "point", "range": 7})"), options).falloff, Falloff::inverse_square);
}

TEST(Gltf, UnitsOfBlendersExporter) {
  RigOptions options;
  const auto point = [&](const std::string& generator) {
    return only_light(gltf(R"({"type": "point", "intensity": 683})", generator), options).intensity.x;
  };
  const auto sun = [&](const std::string& generator) {
    return only_light(gltf(R"({"type": "directional", "intensity": 683})", generator), options).intensity.x;
  };
  EXPECT_DOUBLE_EQ(point("by hand"), 683);
  EXPECT_DOUBLE_EQ(point(blender), 1);
  EXPECT_DOUBLE_EQ(sun(blender), 1);
  options.units = RigOptions::Units::compat;
  EXPECT_DOUBLE_EQ(point(blender), 683);
  EXPECT_DOUBLE_EQ(sun(blender), 683);
  options.units = RigOptions::Units::raw;
  EXPECT_DOUBLE_EQ(point(blender), 683 / (4 * std::numbers::pi));
  EXPECT_DOUBLE_EQ(sun(blender), 683);
  options.units = RigOptions::Units::spec;
  EXPECT_DOUBLE_EQ(point("by hand"), 1);
}

TEST(Gltf, BlendersRangeIsObeyedOnlyWhereAsked) {
  RigOptions options;
  const std::string content = gltf(R"({"type": "point", "range": 7})", blender);
  EXPECT_EQ(only_light(content, options).range, 0);
  options.obey_range = true;
  EXPECT_EQ(only_light(content, options).falloff, Falloff::windowed);
}

TEST(Gltf, BlendersConeIsCycles) {
  // Cycles' rim: t = (c - c0) / ((1 - c0) blend), smoothly; ours: (c - cos outer) / (cos inner - cos outer).
  const double outer = 0.7, blend = 0.3, c0 = std::cos(outer);
  const auto spot = [&](double inner) {
    return only_light(gltf("{\"type\": \"spot\", \"spot\": {\"innerConeAngle\": " + in_digits(inner) + ", \"outerConeAngle\": 0.7}}", blender));
  };
  const Light light = spot(outer * (1 - blend));
  EXPECT_EQ(light.cone, Cone::smoothstep);
  EXPECT_NEAR(std::cos(glm::radians(light.outer_angle)), c0, 1e-15);
  EXPECT_NEAR(std::cos(glm::radians(light.inner_angle)) - c0, (1 - c0) * blend, 1e-14);
  EXPECT_EQ(spot(outer).inner_angle, spot(outer).outer_angle);  // a hard edge
  EXPECT_NEAR(spot(0).inner_angle, 0, 1e-6);
  const Light closed = only_light(gltf(R"({"type": "spot", "spot": {"innerConeAngle": 0, "outerConeAngle": 0}})", blender));
  EXPECT_EQ(closed.inner_angle, 0);
  EXPECT_EQ(closed.outer_angle, 0);
}

TEST(Gltf, AxesTurnForABlenderWorld) {
  const std::string node = R"("translation": [1, 2, 3])", light = R"({"type": "spot", "spot": {}})";
  RigOptions options;
  const auto position = [&](const std::string& generator) { return only_light(gltf(light, generator, node), options).position; };
  EXPECT_EQ(position(blender), glm::dvec3(1, 2, 3));
  options.world_is_z_up = true;
  EXPECT_EQ(position(blender), glm::dvec3(1, -3, 2));
  EXPECT_EQ(only_light(gltf(light, blender, node), options).direction, glm::dvec3(0, 1, 0));
  EXPECT_EQ(position("by hand"), glm::dvec3(1, 2, 3));
  options.up = RigOptions::Up::y;
  EXPECT_EQ(position("by hand"), glm::dvec3(1, -3, 2));
  options.up = RigOptions::Up::z;
  EXPECT_EQ(position(blender), glm::dvec3(1, 2, 3));
  options.world_is_z_up = false;
  options.up = RigOptions::Up::y;
  EXPECT_EQ(position(blender), glm::dvec3(1, 2, 3));
}

TEST(Gltf, NodesStandOnTheirParents) {
  // The parent turns x to y (a quarter about z), scales by 2 and moves; the child has a matrix that moves along x and turns -z to x.
  const Rig rig =
      read_string(R"({"asset": {"version": "2.0"}, "extensions": {"KHR_lights_punctual": {"lights": [{"type": "spot", "spot": {}, "name": "lamp"}]}},
    "scene": 1, "scenes": [{"nodes": [2]}, {"nodes": [0]}],
    "nodes": [{"rotation": [0, 0, 0.70710678118654757, 0.70710678118654757], "scale": [2, 2, 2], "translation": [10, 0, 0], "children": [1]},
              {"matrix": [0,0,1,0, 0,1,0,0, -1,0,0,0, 3,0,0,1], "extensions": {"KHR_lights_punctual": {"light": 0}}, "camera": 0},
              {"extensions": {"KHR_lights_punctual": {"light": 0}}}],
    "cameras": [{"type": "perspective", "perspective": {"yfov": 1, "znear": 0.1}}]})");
  ASSERT_EQ(rig.lights.size(), 1u);
  EXPECT_EQ(rig.lights[0].name, "lamp");
  expect_near(rig.lights[0].position, {10, 6, 0}, 1e-14, "position");
  expect_near(rig.lights[0].direction, {0, 1, 0}, 1e-14, "direction");
  ASSERT_TRUE(rig.camera);
  expect_near(rig.camera->eye(), {10, 6, 0}, 1e-14, "eye");
  expect_near(-glm::dvec3(rig.camera->world_from_camera[2]), {0, 1, 0}, 1e-14, "view");
  expect_near(glm::dvec3(rig.camera->world_from_camera[1]), {-1, 0, 0}, 1e-14, "up");
  EXPECT_NEAR(rig.camera->vertical_fov, glm::degrees(1.0), 1e-12);
}

TEST(Gltf, OrthographicCameraSpansTwiceYmag) {
  const Rig rig = read_string(gltf(R"({"type": "point"})", "by hand", R"("camera": 0)",
                                   R"(, "cameras": [{"type": "orthographic", "orthographic": {"xmag": 3, "ymag": 2, "znear": 0.1, "zfar": 9}}])"));
  ASSERT_TRUE(rig.camera);
  EXPECT_EQ(rig.camera->projection, Camera::Projection::orthographic);
  EXPECT_EQ(rig.camera->height, 4);
}

TEST(Gltf, BuffersAndImagesNeedNotBeThere) {
  const std::string more =
      R"(, "buffers": [{"uri": "not_there.bin", "byteLength": 99}], "images": [{"uri": "not_there.png"}], "meshes": [{"primitives": [{}]}])";
  EXPECT_EQ(only_light(gltf(R"({"type": "point"})", "by hand", "", more)).type, LightType::point);
}

TEST(Gltf, GlbIsToldByItsContent) {
  const std::string content = glb(gltf(R"({"type": "point"})", "by hand", R"("name": "bulb")"));
  EXPECT_EQ(only_light(content).name, "bulb");
  EXPECT_EQ(rig_error(content.substr(0, 15)), "standard input: GLB: cut short in its header");
  EXPECT_EQ(rig_error(content.substr(0, 40)), "standard input: GLB: cut short in its JSON chunk");
  std::string other = content;
  other[4] = 1;
  EXPECT_EQ(rig_error(other), "standard input: GLB: version 1 (2 is known)");
  other = content;
  other[16] = 'B';
  EXPECT_EQ(rig_error(other), "standard input: GLB: its first chunk is not JSON");
}

TEST(Gltf, SaysWhatWasAssumed) {
  RigOptions options;
  options.world_is_z_up = true;
  const std::string camera = R"(, "cameras": [{"type": "perspective", "perspective": {"yfov": 1, "znear": 0.1}}], "animations": [])";
  const std::string content = gltf(R"({"type": "point", "range": 3})", blender, R"("camera": 0)", camera);
  EXPECT_EQ(read_string(content, options).notes,
            (std::vector<std::string>{"units: SPEC (683 lm/W), the default of Blender's exporter; --rig-units compat|raw says otherwise",
                                      "ranges: ignored, as Cycles does; --rig-range obey says otherwise",
                                      "animations: not played; every node stands where the file has it at rest"}));
  EXPECT_EQ(read_string(gltf(R"({"type": "point", "range": 3})"), options).notes,
            (std::vector<std::string>{"units: candela and lux taken as W/sr and W/m^2; --rig-units spec divides by 683 lm/W",
                                      "ranges: obeyed with glTF's window; --rig-range ignore says otherwise"}));
  EXPECT_EQ(read_string(content, options).assumed_axes,
            "axes: y up turned to the G-buffer's z up, the default of Blender's exporter; --rig-up z says that the file has z up");
  EXPECT_EQ(read_string(gltf(R"({"type": "point"})"), options).assumed_axes,
            "axes: taken as they are, although the G-buffer's world has z up; --rig-up y turns the rig");
  EXPECT_EQ(read_string(gltf(R"({"type": "point"})"), {}).assumed_axes,
            "axes and unit: taken to be the G-buffer's own; --rig-up and --rig-scale say otherwise");
  EXPECT_TRUE(read_string(content, options).axes_open && read_string(content, options).scale_open);
  options.units = RigOptions::Units::spec;
  options.up = RigOptions::Up::y;
  options.obey_range = true;
  const Rig said = read_string(gltf(R"({"type": "point", "range": 3})", blender), options);
  EXPECT_EQ(said.notes, std::vector<std::string>{});
  EXPECT_EQ(said.assumed_axes, "");
  EXPECT_FALSE(said.axes_open);
}

TEST(Gltf, RefusesBadFiles) {
  const auto light_error = [](const std::string& light) { return rig_error(gltf(light)); };
  const auto node_error = [](const std::string& node) { return rig_error(gltf(R"({"type": "spot", "spot": {}})", "by hand", node)); };
  EXPECT_EQ(light_error(R"({"type": "area"})"), "standard input: light \"area0\": no glTF light type \"area\" (has: directional, point, spot)");
  EXPECT_EQ(light_error(R"({"type": "point", "intensity": "5"})"), "standard input:1: lights[0]: \"intensity\": must be a number (is a string)");
  EXPECT_EQ(light_error(R"({"type": "point", "intensity": -5})"), "standard input:1: lights[0]: \"intensity\": must not be negative");
  EXPECT_EQ(light_error(R"({"type": "point", "color": [1, 1]})"), "standard input:1: lights[0]: \"color\": must be 3 numbers (has 2)");
  EXPECT_EQ(light_error(R"({"type": "point", "range": 0})"), "standard input:1: lights[0]: \"range\": must be above 0");
  EXPECT_EQ(light_error(R"({"type": "point", "intensity": 1e300})"), "standard input: light \"point0\": \"intensity\" is beyond single precision");
  EXPECT_EQ(light_error(R"({"type": "spot", "spot": {"outerConeAngle": 1.6}})"),
            "standard input:1: lights[0]: spot: \"outerConeAngle\": must be in 0..pi/2");
  EXPECT_EQ(light_error(R"({"type": "spot", "spot": {"innerConeAngle": 0.9}})"),
            "standard input:1: lights[0]: spot: \"innerConeAngle\": must lie between 0 and \"outerConeAngle\"");
  EXPECT_EQ(light_error(R"({"type": "spot"})"), "standard input: glTF: Spot light description not found.");
  EXPECT_EQ(node_error(R"("scale": [0, 0, 0])"), "standard input: light \"spot0\": its node is scaled to nothing, so it has no direction");
  EXPECT_EQ(node_error(R"("rotation": [0, 0, 1])"), "standard input:1: nodes[0]: \"rotation\": must be 4 numbers (has 3)");
  EXPECT_EQ(node_error(R"("children": [0])"), "standard input: glTF: node 0 is reached twice (a node has one parent)");
  EXPECT_EQ(node_error(R"("children": [7])"), "standard input: glTF: node 7 is not there (has 1)");
  EXPECT_EQ(node_error(R"("camera": 2)"), "standard input: glTF: camera 2 is not there (has 0)");
  EXPECT_EQ(rig_error(R"({"asset": {"version": "2.0"}, "nodes": [{"extensions": {"KHR_lights_punctual": {"light": 0}}}]})"),
            "standard input: glTF: light 0 is not there (has 0)");
  EXPECT_EQ(rig_error(R"({"asset": {"version": "2.0"}, "nodes": [{"extensions": {"KHR_lights_punctual": {"light": 1e300}}}]})"),
            "standard input:1: nodes[0]: \"light\": must be the index of a light");
  EXPECT_EQ(rig_error(R"({"asset": {"version": "2.0"}, "nodes": {}})"), "standard input:1: \"nodes\": must be an array");
  EXPECT_EQ(rig_error(R"({"asset": {"version": "1.0"}})"), "standard input: glTF: version \"1.0\" (2.0 is known)");
  EXPECT_EQ(rig_error(R"({"asset": {"version": "2.0"}, "nodes": [{}]})"),
            "standard input: glTF: neither a light nor a camera in its scene (lights are in KHR_lights_punctual)");
  EXPECT_EQ(rig_error(R"({"asset": {"version": "2.0"}, "scene": 3, "scenes": [{"nodes": []}]})"),
            "standard input: glTF: scene 3 is not there (has 1)");
  EXPECT_EQ(rig_error("{\"asset\":\n{\"version\": 2.0,}}"), "standard input:2: not JSON: unexpected '}'; expected string literal");
}

}  // namespace
}  // namespace relume
