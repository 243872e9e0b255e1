// Every case of the corpus understood: convention, roles, spaces, bumps, and the camera against the renderer's own.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

#include "gbuffer/reading.h"
#include "tests/reading_words.h"

namespace relume {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const fs::path corpus = RELUME_CORPUS;

json read_json(const fs::path& file) { return json::parse(std::ifstream(file)); }

std::vector<fs::path> cases_of(const std::string& renderer) {
  std::vector<fs::path> cases;
  for (const auto& entry : fs::directory_iterator(corpus / renderer))
    if (fs::exists(entry.path() / "gbuffer.exr") || fs::exists(entry.path() / "gbuffer.0001.exr")) cases.push_back(entry.path());
  std::sort(cases.begin(), cases.end());
  return cases;
}

#define NEEDS_CORPUS(renderer) \
  if (!fs::exists(corpus / renderer)) GTEST_SKIP() << "the corpus is not beside the project: " << (corpus / renderer)

/// How far apart two cameras put the viewer: as an angle at the scene, whose distance the eye's from the origin stands for.
double apart(const Camera& found, const glm::dvec3& eye, const glm::dvec3& backward) {
  if (found.projection == Camera::Projection::orthographic) return glm::distance(found.backward(), backward);
  return glm::distance(found.eye(), eye) / glm::length(eye);
}

TEST(Reading, MitsubaCorpus) {
  NEEDS_CORPUS("mitsuba");
  double worst = 0;
  std::string worst_case;
  for (const fs::path& folder : cases_of("mitsuba")) {
    SCOPED_TRACE(folder.string());
    const Reading reading = understand(ExrFile(folder / "gbuffer.exr"), {});
    EXPECT_EQ(reading.convention, "mitsuba");
    EXPECT_EQ(layer(reading, "position"), "position");
    EXPECT_EQ(layer(reading, "normal"), "sh_normal");
    EXPECT_EQ(layer(reading, "depth"), "depth");
    EXPECT_EQ(layer(reading, "albedo"), "albedo");
    EXPECT_EQ(layer(reading, "ids"), "shape_index");
    EXPECT_EQ(reading.facing, Facing::one_sided);
    EXPECT_EQ(reading.position_space, Space::world);
    const std::string name = folder.filename();
    const bool filtered = name.starts_with("aa64");
    EXPECT_EQ(reading.position_premultiplied, filtered);
    EXPECT_EQ(layer(reading, "coverage"), name == "aa64_gaussian" || name == "nested_beauty" ? "image" : "");
    const bool plane = name.starts_with("textured") || name == "twosided";
    if (plane) {
      EXPECT_NE(notes(reading).find("one plane"), std::string::npos);
      EXPECT_NE(notes(reading).find("--camera"), std::string::npos);
    }
    ASSERT_EQ(bool(reading.camera), name != "twosided") << "seen from behind, a plane does not tell its viewer's side: " << notes(reading);
    if (!reading.camera) continue;
    EXPECT_EQ(reading.camera->assumed_lens, plane);
    const json rig = read_json(folder / "rig.json")["camera"];
    const auto m = rig["world_from_camera"].get<std::vector<double>>();
    const double off = apart(*reading.camera, {m[3], m[7], m[11]}, {m[2], m[6], m[10]});
    EXPECT_LT(off, filtered ? 5e-3 : 1e-3);  // 64 jittered samples leave a position 0.04 pixels from its centre
    if (!filtered && off > worst) worst = off, worst_case = name;
    if (name != "crop_window") {
      EXPECT_NEAR(reading.camera->vertical_fov, rig.value("vertical_fov", 0.0), 0.1);
    }
    EXPECT_NEAR(reading.camera->height, rig.value("height", 0.0), 1e-3);
    EXPECT_EQ(reading.camera->projection == Camera::Projection::orthographic, rig.contains("height"));
  }
  RecordProperty("worst_eye", std::to_string(worst));
  std::cout << "worst eye " << worst << " of the distance, in " << worst_case << "\n";
}

TEST(Reading, MitsubaBumps) {
  NEEDS_CORPUS("mitsuba");
  const auto read = [](const std::string& name) { return understand(ExrFile(corpus / "mitsuba" / name / "gbuffer.exr"), {}); };
  const Reading normalmap = read("normalmap"), by_default = read("normalmap_default"), bumpmap = read("bumpmap"), mesh = read("mesh_smooth");
  EXPECT_EQ(normalmap.bump_shadowing, BumpShadowing::horizon);
  EXPECT_NE(notes(normalmap).find("24 pixels"), std::string::npos) << notes(normalmap);
  EXPECT_EQ(by_default.bump_shadowing, BumpShadowing::smith);
  EXPECT_EQ(bumpmap.bump_shadowing, BumpShadowing::horizon);
  EXPECT_EQ(mesh.bump_shadowing, BumpShadowing::none);
  EXPECT_TRUE(bumpmap.normal_in_tangent_frame);
  EXPECT_FALSE(normalmap.normal_in_tangent_frame);
  EXPECT_EQ(layer(normalmap, "base_normal"), "geo_normal");
  EXPECT_EQ(layer(mesh, "base_normal"), "");
  EXPECT_EQ(layer(read("diffuse_point"), "base_normal"), "");
  ReadingOptions options;
  options.bump_shadowing = BumpShadowing::smith;
  EXPECT_EQ(understand(ExrFile(corpus / "mitsuba/normalmap/gbuffer.exr"), options).bump_shadowing, BumpShadowing::smith);
}

void check_blender(const fs::path& file, const json& facts, const ReadingOptions& options, double& worst) {
  SCOPED_TRACE(file.string() + " " + options.view_layer + options.view);
  const Reading reading = understand(ExrFile(file), options);
  const bool five = facts["blender"].get<std::string>().starts_with("5");
  EXPECT_EQ(reading.convention, "blender");
  EXPECT_EQ(layer(reading, "position"), "Position");
  EXPECT_EQ(layer(reading, "normal"), "Normal");
  EXPECT_EQ(layer(reading, "depth"), "Depth");
  EXPECT_EQ(layer(reading, "albedo"), five ? "Diffuse Color" : "DiffCol");
  EXPECT_EQ(layer(reading, "glossy_albedo"), five ? "Glossy Color" : "GlossCol");
  for (const auto& [role, aov] : facts["aov"].items())
    EXPECT_EQ(layer(reading, role == "specular" ? "specular_level" : role), aov.get<std::string>());
  EXPECT_EQ(reading.default_specular, "cycles_principled");
  EXPECT_EQ(reading.facing, Facing::as_stored);
  ASSERT_TRUE(reading.camera) << notes(reading);
  if (facts["case"] == "sequence" && file.filename() != "gbuffer.0001.exr") return;  // the camera moves
  std::vector<double> m;
  for (const auto& row : facts["camera"]["world_from_camera"])
    for (const double v : row) m.push_back(v);
  const double off = apart(*reading.camera, {m[3], m[7], m[11]}, {m[2], m[6], m[10]});
  if (options.view == "right") {
    EXPECT_GT(off, 1e-3) << "the right eye stands beside the camera";
    return;
  }
  EXPECT_LT(off, 1e-3);
  worst = std::max(worst, off);
  EXPECT_EQ(reading.camera->projection == Camera::Projection::orthographic, facts["camera"]["type"] == "ortho");
}

TEST(Reading, BlenderCorpus) {
  NEEDS_CORPUS("blender");
  double worst = 0;
  for (const fs::path& folder : cases_of("blender")) {
    const json facts = read_json(folder / "case.json");
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (!entry.path().filename().string().starts_with("gbuffer")) continue;
      for (const std::string view_layer : facts["view_layers"]) {
        ReadingOptions options;
        options.view_layer = view_layer;
        check_blender(entry.path(), facts, options, worst);
        if (!facts["views"].is_null()) {
          options.view = "right";
          check_blender(entry.path(), facts, options, worst);
        }
      }
    }
  }
  std::cout << "worst eye " << worst << " of the distance\n";
}

TEST(Reading, PbrtCorpus) {
  NEEDS_CORPUS("pbrt");
  for (const fs::path& folder : cases_of("pbrt")) {
    SCOPED_TRACE(folder.string());
    const json facts = read_json(folder / "case.json");
    const Reading reading = understand(ExrFile(folder / "gbuffer.exr"), {});
    const Space space = facts["film"]["coordinatesystem"] == "camera" ? Space::camera : Space::world;
    EXPECT_EQ(reading.convention, "pbrt");
    EXPECT_EQ(layer(reading, "normal"), "Ns");
    EXPECT_EQ(layer(reading, "position"), "P");
    EXPECT_EQ(layer(reading, "albedo"), "Albedo");
    EXPECT_EQ(reading.position_space, space);
    EXPECT_EQ(reading.normal_space, space);
    EXPECT_EQ(reading.facing, Facing::two_sided);
    EXPECT_EQ(reading.default_specular, "none");
    ASSERT_TRUE(reading.camera);
    const auto eye = facts["camera"]["eye"].get<std::vector<double>>();
    EXPECT_LT(glm::distance(reading.camera->eye(), {eye[0], eye[1], eye[2]}), 1e-3);
    EXPECT_LT(reading.camera->residual, 0.05);
    EXPECT_EQ(reading.display_window, (Window{0, 0, 160, 120}));
    EXPECT_NEAR(reading.camera->height, 2 * facts["camera"].value("screen_half_height", 0.0), 1e-3);
    EXPECT_NEAR(reading.camera->vertical_fov, facts["camera"].value("fov_of_the_shorter_side", 0.0), 0.02);  // half positions
    // Recovered without the header's help, the same camera comes out.
    if (space == Space::camera) continue;
    ReadingOptions alone;
    alone.recover_camera = true;
    const Reading again = understand(ExrFile(folder / "gbuffer.exr"), alone);
    ASSERT_TRUE(again.camera) << notes(again);
    EXPECT_LT(apart(*again.camera, reading.camera->eye(), reading.camera->backward()), 2e-3) << "half positions";
  }
}

}  // namespace
}  // namespace relume
