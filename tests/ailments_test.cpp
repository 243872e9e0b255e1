// Ailments of pixels: each in a made-up file that has exactly it, with count, box, example pixel and exit code.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "tests/doctored.h"
#include "tests/made_up_exr.h"

namespace relume {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();

TEST(Ailments, HealthyFileHasNoDefect) {
  for (const bool half : {false, true}) {
    MadeUpGBuffer made = healthy();
    made.half = half;
    const Doctored d = doctored(made);
    EXPECT_EQ(d.code, 0);
    EXPECT_EQ(d.defects(), "") << d.json.dump(1);
    EXPECT_TRUE(d.json["understood"]);
  }
}

TEST(Ailments, NotFinite) {
  const Doctored d = with_patch([](ScenePixel& p) { p.albedo.y = nan; });
  expect_patch(d, "not_finite", "defect");
  EXPECT_EQ(d.of("not_finite")[0]["layer"], "albedo");
  EXPECT_EQ(d.of("not_finite")[0]["example"], Json({{"x", 30}, {"y", 33}}));
  expect_patch(with_patch([](ScenePixel& p) { p.position.x = infinity; }), "not_finite", "defect");
  expect_patch(with_patch([](ScenePixel& p) { p.normal.z = -infinity; }), "not_finite", "defect");
}

TEST(Ailments, InfiniteBackgroundIsNone) {
  MadeUpGBuffer made = healthy();
  made.pixel = [](int, int, ScenePixel& pixel) {
    if (pixel.id == 0) pixel.position = {infinity, infinity, infinity};
  };
  EXPECT_EQ(doctored(made).defects(), "");
}

TEST(Ailments, ZeroNormals) {
  expect_patch(with_patch([](ScenePixel& p) { p.normal = {0, 0, 0}; }), "zero_normals", "defect");
}

TEST(Ailments, LongNormals) {
  expect_patch(with_patch([](ScenePixel& p) { p.normal *= 3; }), "long_normals", "hint");
}

TEST(Ailments, AvertedNormals) {
  const auto flip = [](ScenePixel& p) { p.normal *= -1; };
  expect_patch(with_patch(flip), "averted_normals", "defect");
  MadeUpGBuffer made = healthy();
  made.pixel = [&](int x, int y, ScenePixel& p) {
    if (in_patch(x, y)) flip(p);
  };
  EXPECT_EQ(doctored(made, {"--facing", "two-sided"}).code, 0);
}

TEST(Ailments, NormalsInAnotherSpace) {
  MadeUpGBuffer made = MadeUpGBuffer::of_size(256, 256);
  made.pixel = [](int, int, ScenePixel& p) { p.normal = {p.normal.z, p.normal.x, p.normal.y}; };
  const Doctored d = doctored(made, {"--normal-space", "world", "--normal-axes", "x,y,z"});
  ASSERT_EQ(d.of("misplaced_normals").size(), 1u) << d.json.dump(1);
  EXPECT_EQ(d.of("misplaced_normals")[0]["severity"], "defect");
  EXPECT_GT(d.of("misplaced_normals")[0]["pixels"], 1000);
  EXPECT_EQ(d.code, 1);
  made.pixel = nullptr;
  EXPECT_TRUE(doctored(made).of("misplaced_normals").empty());
}

TEST(Ailments, FarPositions) {
  MadeUpGBuffer made = healthy();
  made.pixel = [](int x, int y, ScenePixel& p) {
    if (in_patch(x, y)) p.position *= 1e30;
  };
  const Doctored d = doctored(made);
  ASSERT_EQ(d.of("far_positions").size(), 1u) << d.json.dump(1);
  EXPECT_EQ(d.of("far_positions")[0]["pixels"], 4);
  EXPECT_EQ(d.code, 1);
}

TEST(Ailments, HalfPositionsUnderANearLight) {
  const TemporaryFolder folder;
  const auto rig = [&](const glm::dvec3& p) {
    std::ofstream(folder / "rig.json") << R"({"relume": 1, "lights": [{"type": "point", "intensity": [1, 1, 1], "position": [)" << p.x << ',' << p.y
                                       << ',' << p.z << "]}]}";
    return std::vector<std::string>{"--lights", (folder / "rig.json").string()};
  };
  MadeUpGBuffer made = healthy();
  made.half = true;
  EXPECT_EQ(doctored(made, rig({0, 0, 9})).code, 0);  // 8 units away: 0.0005 of rounding does not show
  // On the surface, at a pixel's own place; the next pixel is a hundred roundings away.
  const std::vector<std::string> near = rig(scene_at(made, 32, 32).position);
  const Doctored d = doctored(made, near);
  ASSERT_EQ(d.of("coarse_positions").size(), 1u) << d.json.dump(1);
  const Json f = d.of("coarse_positions")[0];
  EXPECT_EQ(f["severity"], "defect");
  EXPECT_EQ(f["pixels"], 1);
  EXPECT_EQ(f["box"], Json({{"x0", 32}, {"y0", 32}, {"x1", 33}, {"y1", 33}}));
  EXPECT_EQ(f["example"], Json({{"x", 32}, {"y", 32}}));
  EXPECT_EQ(d.code, 1);
  made.half = false;
  EXPECT_EQ(doctored(made, rig(scene_at(made, 32, 32).position + glm::dvec3(0, 0, 0.01))).code, 0);
}

TEST(Ailments, DepthThatContradictsPositions) {
  // "depth" is 0.5 in the made-up scene unless a value is given for it: a file of its own.
  const auto value = [](bool wrong, bool distance) {
    return [=](const std::string& channel, int x, int y) -> double {
      const MadeUpGBuffer made;
      const ScenePixel p = scene_at(made, x, y);
      const double z = scene_eye_z - p.position.z;
      if (channel == "Z" && p.id == 0) return 1e10;
      if (channel == "Z") return (distance ? glm::length(p.position - glm::dvec3(0, 0, scene_eye_z)) : z) * (wrong && in_patch(x, y) ? 1.5 : 1);
      return double(scene::reader_of(channel)(p));
    };
  };
  const std::vector<MadeUpPart> parts{{"", "", {"P.X", "P.Y", "P.Z", "N.X", "N.Y", "N.Z", "Z"}}};
  const auto camera = [](Imf::Header& h) {
    h.insert("worldToCamera", Imf::M44fAttribute({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, float(scene_eye_z), 1}));
  };
  for (const bool distance : {false, true}) {
    const MadeUpExr right(parts, 64, 64, value(false, distance), camera), wrong(parts, 64, 64, value(true, distance), camera);
    EXPECT_EQ(doctored(right.file).defects(), "");
    expect_patch(doctored(wrong.file), "contradicting_depth", "defect");
  }
}

TEST(Ailments, OutOfRange) {
  expect_patch(with_patch([](ScenePixel& p) { p.albedo.x = -0.5; }), "out_of_range", "defect");
  expect_patch(with_patch([](ScenePixel& p) { p.albedo.x = 1.5; }), "out_of_range", "defect");
  expect_patch(with_patch([](ScenePixel& p) { p.roughness = 1.2; }), "out_of_range", "defect");
  expect_patch(with_patch([](ScenePixel& p) { p.metallic = -1; }), "out_of_range", "defect");
}

/// A float (or uint) id layer with this value in the patch and 1 elsewhere.
Doctored with_ids(const std::string& channel, double value) {
  const MadeUpExr file({{"", "", {"P.X", "P.Y", "P.Z", "N.X", "N.Y", "N.Z", channel}}}, 64, 64, [=](const std::string& c, int x, int y) {
    return c == "id" ? (in_patch(x, y) ? value : 1.0) : double(scene::reader_of(c)(scene_at(MadeUpGBuffer(), x, y)));
  });
  return doctored(file.file);
}

TEST(Ailments, Ids) {
  expect_patch(with_ids("id", 16777218.0), "ids", "defect");
  expect_patch(with_ids("id", 1e-44), "ids", "defect");  // 7 as a whole number
  expect_patch(with_ids("id", 1.5), "ids", "hint");
  expect_patch(with_ids("id:uint", 4294967295.0), "ids", "hint");
  EXPECT_TRUE(with_ids("id", 7).of("ids").empty());
}

TEST(Ailments, MixedPixels) {
  const Doctored d = with_patch([](ScenePixel& p) { p.normal *= 0.8; });
  expect_patch(d, "mixed_pixels", "hint");
  expect_patch(with_patch([](ScenePixel& p) { p.alpha = 0.5; }), "mixed_pixels", "hint");
}

}  // namespace
}  // namespace relume
