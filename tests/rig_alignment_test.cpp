// Rigs in other worlds than the G-buffer's: axes exchanged, mirrored, in other units; found by their cameras, and left alone where those do not tell.
#include "host/rig_alignment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "host/camera_choice.h"

namespace relume {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

Camera looking(const glm::dvec3& eye, const glm::dvec3& target) {
  Camera camera;
  camera.world_from_camera = glm::inverse(glm::lookAt(eye, target, glm::dvec3(0, 1, 0)));
  return camera;
}

/// The camera in a world whose axes and unit are others.
Camera seen_from(const Camera& camera, const glm::dmat3& axes, double scale) {
  Rig rig;
  rig.camera = camera;
  transform(rig, {axes, scale, 0, 0});
  return *rig.camera;
}

const Camera ours = looking({2.2, 1.9, 5.1}, {0.1, 0.5, -0.2});

std::vector<glm::dmat3> all_exchanges() {
  std::vector<glm::dmat3> all;
  int from[] = {0, 1, 2};
  do
    for (int signs = 0; signs < 8; ++signs) {
      glm::dmat3 m(0.0);
      for (int row = 0; row < 3; ++row) m[from[row]][row] = signs & (1 << row) ? -1 : 1;
      all.push_back(m);
    }
  while (std::next_permutation(from, from + 3));
  return all;
}

TEST(RigAlignment, EveryExchangeOfAxesAndEveryScaleIsFound) {
  std::set<std::string> seen;
  for (const glm::dmat3& axes : all_exchanges())
    for (const double scale : {1.0, 100.0, 0.01, 39.3701, 3.7, 0.0254}) {
      const auto found = align(ours, seen_from(ours, axes, scale));
      ASSERT_TRUE(found);
      EXPECT_EQ(found->axes, axes);
      EXPECT_NEAR(found->scale / scale, 1, 1e-5);
      seen.insert(described(*found));
    }
  EXPECT_EQ(seen.size(), 48u * 6);
  EXPECT_TRUE(seen.contains("(x, y, z) becomes 100 (x, -z, y)"));
}

TEST(RigAlignment, WhatRecoveryLeavesDoesNotBlurTheUnit) {
  Camera rough = seen_from(ours, glm::dmat3(1.0), 100);
  rough.world_from_camera[3] += glm::dvec4(0.6, -0.4, 0.5, 0);  // a thousandth of the distance
  const auto found = align(ours, rough);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->scale, 100);
  EXPECT_GT(found->off, 0);
}

TEST(RigAlignment, TheOtherEyeOfAStereoPairHasTheSameWorld) {
  const auto found = align(ours, looking({2.2 + 0.13, 1.9, 5.1 - 0.05}, {0.1, 0.5, -0.2}));
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->is_identity());
}

TEST(RigAlignment, AnotherShotIsNotForced) {
  EXPECT_FALSE(align(ours, looking({-4, 3, 1}, {0, 0, 0})));
  EXPECT_FALSE(align(ours, looking(ours.eye() + 3.0 * ours.backward() + glm::dvec3(4, 0, 0), glm::dvec3(4.1, 0.5, -0.2) - 3.0 * ours.backward())));
  Camera flat = ours;
  flat.projection = Camera::Projection::orthographic;
  EXPECT_FALSE(align(ours, flat));
}

TEST(RigAlignment, OnlyWhatIsUnknownIsSought) {
  const glm::dmat3 z_up(1, 0, 0, 0, 0, 1, 0, -1, 0);
  const Camera turned = seen_from(ours, z_up, 1), larger = seen_from(ours, glm::dmat3(1.0), 100);
  EXPECT_TRUE(align(ours, turned, {true, false}));
  EXPECT_FALSE(align(ours, turned, {false, true}));
  EXPECT_TRUE(align(ours, larger, {false, true}));
  EXPECT_FALSE(align(ours, larger, {true, false}));
}

TEST(RigAlignment, OrthographicCamerasTellTheScaleByTheirHeights) {
  Camera flat = ours;
  flat.projection = Camera::Projection::orthographic;
  flat.height = 3;
  Camera file = seen_from(flat, glm::dmat3(1.0), 100);
  file.world_from_camera[3] += glm::dvec4(700.0 * file.backward(), 0);  // recovered: it may stand anywhere along its axis
  const auto found = align(flat, file);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->scale, 100);
}

TEST(RigAlignment, LightsKeepWhatTheyThrow) {
  Rig rig;
  Light spot;
  spot.type = LightType::spot;
  spot.position = {1, 2, 3};
  spot.direction = {0, 0, -1};
  spot.intensity = {9, 9, 9};
  spot.falloff = Falloff::windowed;
  spot.range = 4;
  Light sun = spot;
  sun.type = LightType::directional;
  rig.lights = {spot, sun};
  transform(rig, {glm::dmat3(1, 0, 0, 0, 0, 1, 0, -1, 0), 100, 0, 0});  // (x, -z, y)
  EXPECT_EQ(rig.lights[0].position, glm::dvec3(100, -300, 200));
  EXPECT_EQ(rig.lights[0].direction, glm::dvec3(0, 1, 0));
  EXPECT_EQ(rig.lights[0].intensity, glm::dvec3(90000));
  EXPECT_EQ(rig.lights[0].range, 400);
  EXPECT_EQ(rig.lights[1].intensity, glm::dvec3(9)) << "a sun is as bright everywhere";
}

/// A Blender case that the project keeps, with its rig put into another world by a node above all others.
class RigOfAnotherWorld : public testing::Test {
 protected:
  RigOfAnotherWorld() { options.world_is_z_up = true, options.convention = "blender"; }
  ~RigOfAnotherWorld() override { fs::remove(file); }

  void write(const json& root_node, double intensity) {
    json gltf = json::parse(std::ifstream(folder / "rig.gltf"));
    json root = root_node;
    root["children"] = gltf["scenes"][0]["nodes"];
    gltf["scenes"][0]["nodes"] = {gltf["nodes"].size()};
    gltf["nodes"].push_back(root);
    for (json& light : gltf["extensions"]["KHR_lights_punctual"]["lights"])
      if (light["type"] != "directional") light["intensity"] = light["intensity"].get<double>() * intensity;
    std::ofstream(file) << gltf;
  }

  Rig settled(const fs::path& path) {
    std::vector<Rig> rigs{read_rig(path, options)};
    reading = understand_with_rigs(ExrFile(folder / "gbuffer.exr"), {}, rigs);
    return rigs.front();
  }

  void expect_as_exported() {
    const Rig rig = settled(file);
    options.scale.reset();
    const Rig truth = settled(folder / "rig.gltf");
    ASSERT_EQ(rig.lights.size(), truth.lights.size());
    for (std::size_t i = 0; i < rig.lights.size(); ++i) {
      const Light &a = rig.lights[i], &b = truth.lights[i];
      EXPECT_LT(glm::distance(a.position, b.position), 1e-5 * glm::length(b.position)) << i;
      EXPECT_TRUE(a.type == LightType::point || glm::distance(a.direction, b.direction) < 1e-5) << i;
      EXPECT_LT(glm::distance(a.intensity, b.intensity), 1e-5 * glm::length(b.intensity)) << i;
    }
    ASSERT_TRUE(reading.camera);
    EXPECT_LT(reading.camera->residual, 0.01);
  }

  bool noted(const Rig& rig, const std::string& words) const {
    return std::any_of(rig.notes.begin(), rig.notes.end(), [&](const std::string& note) { return note.find(words) != std::string::npos; });
  }

  const fs::path folder = fs::path(RELUME_SOURCE) / "tests/data/corpus/blender/principled-ggx";
  const fs::path file = fs::temp_directory_path() / ("relume-rig-" + std::to_string(getpid()) + ".gltf");
  RigOptions options;
  Reading reading;
};

TEST_F(RigOfAnotherWorld, Centimetres) {
  write({{"scale", {100, 100, 100}}}, 1e4);
  expect_as_exported();
  EXPECT_TRUE(noted(settled(file), "becomes 0.01 (x, y, z)"));
}

TEST_F(RigOfAnotherWorld, LeftHanded) {
  write({{"scale", {-1, 1, 1}}}, 1);
  expect_as_exported();
  EXPECT_TRUE(noted(settled(file), "becomes (-x, y, z)"));
}

TEST_F(RigOfAnotherWorld, ZUpInMillimetresMirrored) {
  write({{"matrix", {1000, 0, 0, 0, 0, 0, 1000, 0, 0, 1000, 0, 0, 0, 0, 0, 1}}}, 1e6);
  expect_as_exported();
}

TEST_F(RigOfAnotherWorld, OptionsOverrule) {
  write({{"scale", {100, 100, 100}}}, 1e4);
  options.scale = 0.01;
  expect_as_exported();
  options.scale = 0.02;
  EXPECT_TRUE(noted(settled(file), "no exchange of axes and no scale"));
}

TEST_F(RigOfAnotherWorld, AJsonRigIsToldNotTurned) {
  const Rig truth = settled(folder / "rig.gltf");
  json camera = {{"world_from_camera", json::array()}, {"vertical_fov", 40}};
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) camera["world_from_camera"].push_back(truth.camera->world_from_camera[c][r] * (c == 3 && r < 3 ? 100 : 1));
  std::ofstream(file) << json{
      {"relume", 1}, {"camera", camera}, {"lights", json::array({{{"type", "point"}, {"position", {100, 200, 300}}, {"intensity", {1, 1, 1}}}})}};
  const Rig rig = settled(file);
  EXPECT_EQ(rig.lights.front().position, glm::dvec3(100, 200, 300));
  EXPECT_TRUE(noted(rig, "becomes 0.01 (x, y, z)"));
  EXPECT_TRUE(noted(rig, "a JSON rig is taken as it is"));
}

TEST_F(RigOfAnotherWorld, WithoutACameraTheExportersDefaultIsSaid) {
  json gltf = json::parse(std::ifstream(folder / "rig.gltf"));
  for (json& node : gltf["nodes"]) node.erase("camera");
  std::ofstream(file) << gltf;
  EXPECT_TRUE(noted(settled(file), "the default of Blender's exporter; --rig-up z says that the file has z up (it has no camera to tell by)"));
}

}  // namespace
}  // namespace relume
