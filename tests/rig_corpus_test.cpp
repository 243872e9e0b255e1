// Every rig that Blender exported for the corpus, against the lights and cameras as Blender itself gives them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "host/json.h"
#include "host/rig.h"

namespace relume {
namespace {

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double tolerance, const std::string& what) {
  EXPECT_LE(glm::length(a - b), tolerance * std::max(glm::length(b), 1e-300)) << what;
}

glm::dvec3 vector_of(const Json& json) { return {json.items[0].number, json.items[1].number, json.items[2].number}; }

RigOptions options_of(const Json& test_case) {
  RigOptions options;
  options.world_is_z_up = true;
  options.convention = "blender";
  const std::vector<Json>& words = test_case.find("relume_shade")->items;
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    if (words[i].string == "--rig-units")
      options.units = words[i + 1].string == "compat" ? RigOptions::Units::compat
                      : words[i + 1].string == "raw"  ? RigOptions::Units::raw
                                                      : RigOptions::Units::spec;
    if (words[i].string == "--rig-up") options.up = words[i + 1].string == "z" ? RigOptions::Up::z : RigOptions::Up::y;
  }
  return options;
}

void check_light(const Light& light, const Json& truth, const std::string& where) {
  const std::string type = truth.find("type")->string;
  EXPECT_EQ(light.type, type == "sun" ? LightType::directional : type == "spot" ? LightType::spot : LightType::point) << where;
  const char* strength = type == "sun" ? "irradiance_W_m2" : "intensity_W_sr";
  expect_near(light.intensity, truth.find(strength)->number * vector_of(*truth.find("color")), 1e-6, where + " intensity");
  expect_near(light.position, vector_of(*truth.find("position")), 1e-6, where + " position");
  if (type != "point") expect_near(light.direction, vector_of(*truth.find("direction")), 1e-6, where + " direction");
  EXPECT_EQ(light.falloff, Falloff::inverse_square) << where;
  if (type != "spot") return;
  const double c0 = std::cos(truth.find("spot_size")->number / 2), blend = truth.find("spot_blend")->number;
  EXPECT_EQ(light.cone, Cone::smoothstep) << where;
  EXPECT_NEAR(std::cos(glm::radians(light.outer_angle)), c0, 1e-6) << where;
  EXPECT_NEAR(std::cos(glm::radians(light.inner_angle)) - std::cos(glm::radians(light.outer_angle)), (1 - c0) * blend, 1e-6) << where;
}

void check_camera(const Camera& camera, const Json& test_case, const std::string& where) {
  const Json& truth = *test_case.find("camera");
  const std::vector<Json>& rows = truth.find("world_from_camera")->items;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      EXPECT_NEAR(camera.world_from_camera[column][row], rows[row].items[column].number, 1e-6 * (column == 3 ? 10 : 1)) << where << row << column;
  const std::vector<Json>& size = test_case.find("resolution")->items;
  const double width = size[0].number, height = size[1].number;
  EXPECT_GT(width, height) << where;  // then Blender's numbers are for the width
  if (truth.find("type")->string == "ortho") {
    EXPECT_EQ(camera.projection, Camera::Projection::orthographic) << where;
    EXPECT_NEAR(camera.height, truth.find("ortho_scale")->number * height / width, 1e-6 * camera.height) << where;
  } else {
    EXPECT_EQ(camera.projection, Camera::Projection::perspective) << where;
    const double half = std::tan(truth.find("fov_x")->number / 2) * height / width;
    EXPECT_NEAR(std::tan(glm::radians(camera.vertical_fov) / 2), half, 1e-6 * half) << where;
  }
}

TEST(Corpus, BlendersRigsAreWhatBlenderSays) {
  const std::filesystem::path corpus = std::filesystem::path(RELUME_CORPUS) / "blender";
  if (!std::filesystem::exists(corpus)) GTEST_SKIP() << "the corpus is not beside the project";
  int cases = 0, lights = 0;
  for (const auto& folder : std::filesystem::directory_iterator(corpus)) {
    const std::filesystem::path file = folder.path() / "case.json";
    if (!std::filesystem::exists(file)) continue;
    const Json test_case = parse_json(read_text(file), file.string());
    const Json* truth = test_case.find("rig");
    if (!truth) continue;
    const std::string where = folder.path().filename().string() + ": ";
    const Rig rig = read_rig(folder.path() / truth->find("file")->string, options_of(test_case));
    ASSERT_TRUE(rig.camera) << where;
    check_camera(*rig.camera, test_case, where);
    std::size_t found = 0;
    for (const Json& light : truth->find("lights")->items) {
      const std::string& name = light.find("name")->string;
      if (light.find("type")->string == "area") continue;  // glTF has none: the exporter drops them
      const auto match = std::find_if(rig.lights.begin(), rig.lights.end(), [&](const Light& l) { return l.name == name; });
      ASSERT_NE(match, rig.lights.end()) << where << name;
      check_light(*match, light, where + name);
      ++found;
    }
    EXPECT_EQ(rig.lights.size(), found) << where;
    lights += static_cast<int>(found);
    ++cases;
  }
  EXPECT_GE(cases, 35);
  EXPECT_GE(lights, 350);
}

}  // namespace
}  // namespace relume
