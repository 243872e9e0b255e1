// The JSON rig file: every key, every refusal with its whole text, several rigs as one, and the corpus.
#include "host/rig.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <glm/geometric.hpp>

#include "host/json.h"
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

Rig rig_of(const std::string& light) { return read_string("{\"relume\": 1, \"lights\": [" + light + "]}"); }

std::string light_error(const std::string& light) {
  return after("standard input:1: lights[0]: ", error_of([&] { rig_of(light); }));
}

std::string camera_error(const std::string& camera) {
  return after("standard input:1: camera: ", rig_error("{\"relume\": 1, \"camera\": " + camera + "}"));
}

const std::string identity = "[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]";

TEST(JsonRig, ReadsTheContractsExample) {
  const Rig rig = read_string(R"({"relume": 1,
     "camera": {"world_from_camera": [0,0,1,5, 1,0,0,6, 0,1,0,7, 0,0,0,1], "vertical_fov": 40},
     "lights": [
       {"type": "point", "name": "key", "position": [0,2,1], "intensity": [30,28,25]},
       {"type": "point", "position": [1,1,0], "intensity": [1,1,1], "falloff": "linear", "range_begin": 4, "range": 5},
       {"type": "spot", "position": [0,3,0], "direction": [0,-2,0], "intensity": [9,9,9], "inner_angle": 20, "outer_angle": 30, "cone": "gltf"},
       {"type": "directional", "direction": [0,-3,-4], "intensity": 3},
       {"type": "ambient", "intensity": [0.02,0.02,0.02]},
       {"type": "ambient", "fraction": 0.01}]})");
  ASSERT_EQ(rig.lights.size(), 6u);
  EXPECT_EQ(rig.lights[0].name, "key");
  EXPECT_EQ(rig.lights[0].type, LightType::point);
  EXPECT_EQ(rig.lights[0].position, glm::dvec3(0, 2, 1));
  EXPECT_EQ(rig.lights[0].intensity, glm::dvec3(30, 28, 25));
  EXPECT_EQ(rig.lights[0].falloff, Falloff::inverse_square);
  EXPECT_EQ(rig.lights[0].range, 0);
  EXPECT_EQ(rig.lights[1].name, "point1");
  EXPECT_EQ(rig.lights[1].falloff, Falloff::linear);
  EXPECT_EQ(rig.lights[1].range_begin, 4);
  EXPECT_EQ(rig.lights[1].range, 5);
  EXPECT_EQ(rig.lights[2].direction, glm::dvec3(0, -1, 0));
  EXPECT_EQ(rig.lights[2].inner_angle, 20);
  EXPECT_EQ(rig.lights[2].outer_angle, 30);
  EXPECT_EQ(rig.lights[2].cone, Cone::gltf);
  EXPECT_LE(glm::length(rig.lights[3].direction - glm::dvec3(0, -0.6, -0.8)), 1e-15);
  EXPECT_EQ(rig.lights[3].intensity, glm::dvec3(3));
  EXPECT_EQ(rig.lights[4].type, LightType::ambient);
  EXPECT_FALSE(rig.lights[4].fraction);
  EXPECT_EQ(rig.lights[5].fraction, 0.01);
  ASSERT_TRUE(rig.camera);
  EXPECT_EQ(rig.camera->eye(), glm::dvec3(5, 6, 7));
  EXPECT_EQ(glm::dvec3(rig.camera->world_from_camera[0]), glm::dvec3(0, 1, 0));  // the first column, given row by row
  EXPECT_EQ(rig.camera->vertical_fov, 40);
  EXPECT_EQ(rig.camera->source, "standard input");
}

TEST(JsonRig, LinksLightsToObjects) {
  const Rig rig = read_string(R"({"relume": 1, "ids": "CryptoObject", "lights": [
     {"type": "directional", "direction": [0,0,-1], "intensity": 1, "include": ["torus", "/world/12", 4294967295]},
     {"type": "ambient", "intensity": 1, "exclude": [0]},
     {"type": "ambient", "intensity": 1}]})");
  ASSERT_EQ(rig.lights.size(), 3u);
  EXPECT_EQ(rig.lights[0].include, (std::vector<std::string>{"torus", "/world/12", "4294967295"}));
  EXPECT_EQ(rig.lights[1].exclude, std::vector<std::string>{"0"});
  EXPECT_TRUE(rig.lights[2].include.empty() && rig.lights[2].exclude.empty());
  EXPECT_EQ(rig.lights[2].ids, "CryptoObject");
  const std::string ambient = R"({"type": "ambient", "intensity": 1, )";
  EXPECT_EQ(light_error(ambient + R"("include": "torus"})"), "\"include\": must be an array of at least one object's name or id");
  EXPECT_EQ(light_error(ambient + R"("exclude": []})"), "\"exclude\": must be an array of at least one object's name or id");
  for (const char* bad : {"-1", "1.5", "4294967296", "true", "\"\"", "[1]"})
    EXPECT_EQ(after("standard input:1: lights[0]: ", rig_error("{\"relume\": 1, \"lights\": [" + ambient + "\"include\": [" + bad + "]}]}")),
              "\"include\": must be objects' names or ids (0..4294967295)");
  EXPECT_EQ(light_error(ambient + R"("include": [1], "exclude": [2]})"), "\"exclude\": stands instead of \"include\" (give one of them)");
}

TEST(JsonRig, CommonKeys) {
  const Rig rig = read_string(R"({"relume": 1, "lights": [
     {"type": "point", "position": [0,0,0], "intensity": 2, "exposure": 3, "group": "fill"},
     {"type": "point", "position": [0,0,0], "intensity": [-1, 0, 1], "name": "key", "enabled": false},
     {"type": "ambient", "fraction": 0.01, "exposure": -1, "name": "key", "enabled": true},
     {"type": "rect", "width": 2, "enabled": false},
     {"type": "directional", "direction": [1e-200, 0, 0], "intensity": [-1, 0, 1], "name": "key"},
     {"type": "point", "position": [0,0,0], "intensity": 2, "name": "key_2", "range": 3},
     {"type": "spot", "position": [0,0,0], "direction": [0,0,1], "intensity": 2, "cone": "linear", "falloff": "none"}]})");
  ASSERT_EQ(rig.lights.size(), 5u);
  EXPECT_EQ(rig.lights[0].intensity, glm::dvec3(16));
  EXPECT_EQ(rig.lights[0].group, "fill");
  EXPECT_EQ(rig.lights[1].fraction, 0.005);
  EXPECT_EQ(rig.lights[1].name, "key");
  EXPECT_EQ(rig.lights[2].name, "key_2");
  EXPECT_EQ(rig.lights[2].direction, glm::dvec3(1, 0, 0));
  EXPECT_EQ(rig.lights[2].intensity, glm::dvec3(-1, 0, 1));
  EXPECT_EQ(rig.lights[3].name, "key_2_2");
  EXPECT_EQ(rig.lights[3].falloff, Falloff::windowed);
  EXPECT_EQ(rig.lights[4].name, "spot6");
  EXPECT_EQ(rig.lights[4].cone, Cone::linear);
  EXPECT_EQ(rig.lights[4].falloff, Falloff::none);
  EXPECT_EQ(rig.lights[4].inner_angle, 0);
  EXPECT_EQ(rig.lights[4].outer_angle, 45);
}

TEST(JsonRig, RefusesBadLights) {
  const std::string point = R"("type": "point", "position": [0,0,0], "intensity": 1)",
                    spot = R"("type": "spot", "position": [0,0,0], "direction": [0,0,1], "intensity": 1)";
  EXPECT_EQ(light_error("5"), "must be an object (is a number)");
  EXPECT_EQ(light_error("{}"), "\"type\" is missing");
  EXPECT_EQ(light_error(R"({"type": "bulb"})"), "\"type\": must be one of directional, point, spot, ambient, environment");
  for (const std::string type : {"rect", "disk", "sphere"})
    EXPECT_EQ(light_error("{\"type\": \"" + type + "\"}"),
              "\"type\": \"" + type + "\" is not supported yet (has: directional, point, spot, ambient, environment)");
  EXPECT_EQ(light_error("{" + point + R"(, "colour": 1})"),
            "unknown key \"colour\" (has: type, name, group, enabled, exposure, include, exclude, position, intensity, falloff, range_begin, range)");
  EXPECT_EQ(light_error("{" + point + R"(, "cone": "gltf"})"),
            "unknown key \"cone\" (has: type, name, group, enabled, exposure, include, exclude, position, intensity, falloff, range_begin, range)");
  EXPECT_EQ(light_error(R"({"type": "point", "intensity": 1})"), "\"position\" is missing");
  EXPECT_EQ(light_error(R"({"type": "point", "position": [0,0,0]})"), "\"intensity\" is missing");
  EXPECT_EQ(light_error(R"({"type": "point", "position": [0,0], "intensity": 1})"), "\"position\": must be 3 numbers (has 2)");
  EXPECT_EQ(light_error(R"({"type": "point", "position": 1, "intensity": 1})"), "\"position\": must be 3 numbers (is a number)");
  EXPECT_EQ(light_error(R"({"type": "point", "position": [1e39,0,0], "intensity": 1})"), "\"position\": is beyond single precision");
  EXPECT_EQ(light_error(R"({"type": "directional", "direction": [0,0,0], "intensity": 1})"), "\"direction\": must not be zero");
  EXPECT_EQ(light_error("{" + point + R"(, "exposure": 200})"), "\"intensity\": is beyond single precision");
  EXPECT_EQ(light_error("{" + point + R"(, "enabled": 0})"), "\"enabled\": must be true or false (is a number)");
  EXPECT_EQ(light_error("{" + point + R"(, "name": 1})"), "\"name\": must be a string (is a number)");
  EXPECT_EQ(light_error("{" + point + R"(, "falloff": "cubic"})"), "\"falloff\": must be one of inverse_square, windowed, linear, none");
  EXPECT_EQ(light_error("{" + point + R"(, "falloff": "windowed"})"), "\"falloff\": needs \"range\"");
  EXPECT_EQ(light_error("{" + point + R"(, "falloff": "linear"})"), "\"falloff\": needs \"range\"");
  EXPECT_EQ(light_error("{" + point + R"(, "range": 0})"), "\"range\": must be above 0");
  EXPECT_EQ(light_error("{" + point + R"(, "range": 1, "falloff": "none"})"),
            "\"range\": has no meaning for this \"falloff\" (windowed and linear have one)");
  EXPECT_EQ(light_error("{" + point + R"(, "range": 1, "range_begin": 0})"), "\"range_begin\": is for \"falloff\": \"linear\" alone");
  EXPECT_EQ(light_error("{" + point + R"(, "range": 1, "range_begin": -1, "falloff": "linear"})"), "\"range_begin\": must not be negative");
  EXPECT_EQ(light_error("{" + point + R"(, "range": 1, "range_begin": 1, "falloff": "linear"})"), "\"range_begin\": must be below \"range\"");
  EXPECT_EQ(light_error("{" + spot + R"(, "outer_angle": 91})"), "\"outer_angle\": must be in 0..90 degrees, from the axis to the rim");
  EXPECT_EQ(light_error("{" + spot + R"(, "outer_angle": -1})"), "\"outer_angle\": must be in 0..90 degrees, from the axis to the rim");
  EXPECT_EQ(light_error("{" + spot + R"(, "inner_angle": 31, "outer_angle": 30.5})"),
            "\"inner_angle\": must lie between 0 and \"outer_angle\" (30.5 degrees)");
  EXPECT_EQ(light_error("{" + spot + R"(, "cone": "round"})"), "\"cone\": must be one of gltf, smoothstep, linear");
  EXPECT_EQ(light_error(R"({"type": "ambient"})"), "\"intensity\" is missing");
  EXPECT_EQ(light_error(R"({"type": "ambient", "fraction": 0.1, "intensity": 1})"),
            "\"fraction\": stands instead of \"intensity\" (give one of them)");
  EXPECT_EQ(light_error(R"({"type": "ambient", "fraction": -0.1})"), "\"fraction\": must not be negative");
}

TEST(JsonRig, RefusesBadFiles) {
  EXPECT_EQ(rig_error("[]"), "standard input:1: must be an object (is an array)");
  EXPECT_EQ(rig_error("{}"), "standard input:1: \"relume\" is missing");
  EXPECT_EQ(rig_error("{\"relume\": 2}"), "standard input:1: \"relume\": this version of the file is not known (1 is)");
  EXPECT_EQ(rig_error("{\"relume\": 1, \"light\": []}"), "standard input:1: unknown key \"light\" (has: relume, camera, ids, lights)");
  EXPECT_EQ(rig_error("{\"relume\": 1,\n\"lights\": {}}"), "standard input:2: \"lights\": must be an array");
  EXPECT_EQ(rig_error("{\"relume\": 1,\n\"lights\": [\n{\"type\": \"point\",\n\"position\": [0, 1e999, 0]}]}"),
            "standard input:4: number 1e999 is beyond the range of a double");
  EXPECT_EQ(error_of([] { read_rig("/nowhere/rig.json", {}); }), "/nowhere/rig.json: no such file");
}

TEST(JsonRig, RefusesBadCameras) {
  EXPECT_EQ(camera_error("[]"), "must be an object (is an array)");
  EXPECT_EQ(camera_error("{}"), "\"world_from_camera\" is missing");
  EXPECT_EQ(camera_error("{\"world_from_camera\": [1, 2]}"), "\"world_from_camera\": must be 16 numbers (has 2)");
  EXPECT_EQ(camera_error("{\"world_from_camera\": " + identity + ", \"fov\": 40}"),
            "unknown key \"fov\" (has: type, world_from_camera, vertical_fov)");
  EXPECT_EQ(camera_error("{\"world_from_camera\": " + identity + ", \"vertical_fov\": 180}"), "\"vertical_fov\": must lie between 0 and 180 degrees");
  EXPECT_EQ(camera_error("{\"world_from_camera\": " + identity + ", \"type\": \"orthographic\", \"height\": 0}"),
            "\"height\": must be above 0 (world units)");
  EXPECT_EQ(camera_error("{\"world_from_camera\": " + identity + ", \"type\": \"orthographic\", \"vertical_fov\": 9}"),
            "unknown key \"vertical_fov\" (has: type, world_from_camera, height)");
  EXPECT_EQ(camera_error("{\"world_from_camera\": " + identity + ", \"type\": \"fisheye\"}"), "\"type\": must be one of perspective, orthographic");
  EXPECT_EQ(camera_error("{\"world_from_camera\": [2,0,0,0, 0,2,0,0, 0,0,2,0, 0,0,0,1]}"),
            "\"world_from_camera\": must be a rigid motion: its first three columns unit vectors at right angles");
  EXPECT_EQ(camera_error("{\"world_from_camera\": [1,0,0,0, 0,1,0,0, 0,0,1,0, 3,4,5,1]}"),  // column by column
            "\"world_from_camera\": its last row must be 0, 0, 0, 1 (16 numbers, row by row)");
}

TEST(JsonRig, ALeftHandedCameraIsACamera) {
  const Rig rig = read_string(
      "{\"relume\": 1, \"camera\": {\"world_from_camera\": [-1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1], \"type\": \"orthographic\", \"height\": 3}}");
  ASSERT_TRUE(rig.camera);
  EXPECT_EQ(rig.camera->projection, Camera::Projection::orthographic);
  EXPECT_EQ(rig.camera->height, 3);
  EXPECT_EQ(rig.camera->world_from_camera[0][0], -1);
}

TEST(Merge, KeepsOrderAndTheFirstCamera) {
  const std::string lights = R"("lights": [{"type": "ambient", "intensity": 1}]})";
  const auto camera = [&](int fov) {
    return "{\"relume\": 1, \"camera\": {\"world_from_camera\": " + identity + ", \"vertical_fov\": " + std::to_string(fov) + "}, ";
  };
  const Rig rig = merge({read_string("{\"relume\": 1, " + lights), read_string(camera(30) + lights), read_string(camera(50) + lights)});
  ASSERT_EQ(rig.lights.size(), 3u);
  EXPECT_EQ(rig.lights[0].name, "ambient0");
  EXPECT_EQ(rig.lights[1].name, "ambient0_2");
  EXPECT_EQ(rig.lights[2].name, "ambient0_3");
  EXPECT_EQ(rig.camera->vertical_fov, 30);
}

TEST(Corpus, JsonRigsAreReadOrSayWhatIsNotThereYet) {
  if (!std::filesystem::exists(RELUME_CORPUS)) GTEST_SKIP() << "the corpus is not beside the project";
  int read = 0, later = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(RELUME_CORPUS)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with("rig") || entry.path().extension() != ".json") continue;
    const std::string text = read_text(entry.path());
    const std::string error = error_of([&] { EXPECT_FALSE(read_rig(entry.path(), {}).lights.empty()) << entry.path(); });
    const bool soft = text.find("\"rect\"") != std::string::npos || text.find("\"sphere\"") != std::string::npos;
    if (soft)
      EXPECT_NE(error.find("is not supported yet (has: directional, point, spot, ambient, environment)"), std::string::npos) << error;
    else
      EXPECT_EQ(error, "no error") << entry.path();
    ++(soft ? later : read);
  }
  EXPECT_GE(read, 45);
  EXPECT_GE(later, 3);
}

}  // namespace
}  // namespace relume
