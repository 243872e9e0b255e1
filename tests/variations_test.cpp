// One scene, stored in many ways: camera space, 0..1 normals, flipped components, left-handed, z up, other units. Without a flag, one picture.
#include <ImfFloatAttribute.h>
#include <ImfMatrixAttribute.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <nlohmann/json.hpp>
#include <random>

#include "tests/channels.h"
#include "tests/made_up_exr.h"
#include "tests/make_gbuffer.h"
#include "tests/run_program.h"

namespace relume {
namespace {

using glm::dmat3;
using glm::dvec3;

dmat3 turned(double x, double y) {
  const dmat3 about_x(1, 0, 0, 0, std::cos(x), std::sin(x), 0, -std::sin(x), std::cos(x));
  const dmat3 about_y(std::cos(y), 0, -std::sin(y), 0, 1, 0, std::sin(y), 0, std::cos(y));
  return about_y * about_x;
}

/// How one file tells of the scene (tests/make_gbuffer.h, seen along -z from (0, 0, 5)).
struct Variation {
  const char* name;
  dmat3 world_from_scene = turned(0.4, 0.7);  ///< a rotation that no two axes share, perhaps mirrored
  dvec3 origin{3, -1, 2};
  bool camera_in_header = true, half = false, positions_in_camera = false, normals_in_camera = false;
  std::function<void(ScenePixel&)> scene = [](ScenePixel&) {};  ///< changes what is there to be seen
  std::function<dvec3(const dvec3&)> normal_stored = [](const dvec3& n) { return n; };
  double stored_units = 1;  ///< of positions, for one of the header's camera
  double wanted = 60;       ///< dB against the plain file
};

const dvec3 scene_eye{0, 0, scene_eye_z};

Imf::M44fAttribute world_to_camera(const Variation& v) {
  dmat3 axes = v.world_from_scene;
  axes[2] *= -1.0;  // the attribute's camera looks along +z
  const dmat3 camera_from_world = glm::transpose(axes);
  const dvec3 t = -(camera_from_world * (v.world_from_scene * scene_eye + v.origin));
  Imath::M44f m;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) m[i][j] = float(camera_from_world[i][j]);  // row vectors
  for (int j = 0; j < 3; ++j) m[3][j] = float(t[j]);
  return Imf::M44fAttribute(m);
}

nlohmann::json numbers(const dvec3& v) { return {v.x, v.y, v.z}; }

void write_rig(const std::filesystem::path& file, const Variation& v) {
  const nlohmann::json rig{{"relume", 1},
                           {"lights",
                            {{{"type", "point"}, {"position", numbers(v.world_from_scene * dvec3(2, 2, 3) + v.origin)}, {"intensity", {30, 25, 20}}},
                             {{"type", "directional"}, {"direction", numbers(v.world_from_scene * dvec3(1, -1, -0.5))}, {"intensity", {1, 2, 3}}}}}};
  std::ofstream(file) << rig;
}

void write_variation(const std::filesystem::path& file, const Variation& v) {
  MadeUpGBuffer made = MadeUpGBuffer::of_size(160, 120);
  made.with({"albedo.R", "albedo.G", "albedo.B", "roughness", "metallic"});
  made.half = v.half;
  made.camera_in_header = false;
  made.pixel = [&](int, int, ScenePixel& pixel) {
    v.scene(pixel);
    if (pixel.id == 0) return;
    pixel.position = v.stored_units * (v.positions_in_camera ? pixel.position - scene_eye : v.world_from_scene * pixel.position + v.origin);
    pixel.normal = v.normal_stored(v.normals_in_camera ? pixel.normal : v.world_from_scene * pixel.normal);
  };
  if (v.camera_in_header) made.header = [&](Imf::Header& header) { header.insert("worldToCamera", world_to_camera(v)); };
  write_gbuffer(file, made);
}

Channels relit(const Variation& v) {
  const TemporaryFolder folder;
  write_variation(folder / "in.exr", v);
  write_rig(folder / "rig.json", v);
  const ProgramRun run = run_program({"shade", (folder / "in.exr").string(), "-l", (folder / "rig.json").string(), "-o",
                                      (folder / "out.exr").string(), "--device", "twin", "--quiet"});
  EXPECT_EQ(run.code, 0) << v.name << ": " << run.err;
  return run.code == 0 ? read_channels(folder / "out.exr") : Channels{};
}

double psnr(const Channels& image, const Channels& reference) {
  double squares = 0, peak = 0;
  std::size_t count = 0;
  for (const char* channel : {"R", "G", "B"})
    for (std::size_t i = 0; i < reference.at(channel).size(); ++i, ++count) {
      squares += std::pow(double(image.at(channel)[i]) - reference.at(channel)[i], 2);
      peak = std::max(peak, double(reference.at(channel)[i]));
    }
  return 10 * std::log10(peak * peak * double(count) / std::max(squares, 1e-30));
}

dvec3 encoded(const dvec3& n) { return 0.5 * n + 0.5; }
dvec3 in_bytes(const dvec3& n) { return glm::round(encoded(n) * 255.0) / 255.0; }

std::vector<Variation> variations() {
  const dmat3 z_up(1, 0, 0, 0, 0, 1, 0, -1, 0), mirrored(1, 0, 0, 0, 1, 0, 0, 0, -1), turn = turned(0.4, 0.7);
  return {
      {.name = "no camera in the header", .camera_in_header = false},
      {.name = "positions and normals in camera space", .positions_in_camera = true, .normals_in_camera = true},
      {.name = "normals alone in camera space", .normals_in_camera = true},
      {.name = "normals alone in camera space, z into the scene",
       .normals_in_camera = true,
       .normal_stored = [](const dvec3& n) { return n * dvec3(1, 1, -1); }},
      {.name = "normals 0..1", .normal_stored = encoded},
      {.name = "normals in camera space, 0..1", .normals_in_camera = true, .normal_stored = encoded},
      {.name = "flipped green", .normal_stored = [](const dvec3& n) { return n * dvec3(1, -1, 1); }},
      {.name = "flipped green, 0..1", .normal_stored = [](const dvec3& n) { return encoded(n * dvec3(1, -1, 1)); }},
      {.name = "normals z up, positions y up", .normal_stored = [](const dvec3& n) { return dvec3(n.x, -n.z, n.y); }},
      {.name = "left-handed", .world_from_scene = mirrored * turn},
      {.name = "left-handed, no camera", .world_from_scene = mirrored * turn, .camera_in_header = false},
      {.name = "z up", .world_from_scene = z_up * turn},
      {.name = "positions in centimetres, the camera in metres", .stored_units = 100},
      {.name = "half", .half = true, .wanted = 40},
      {.name = "half, camera space", .half = true, .positions_in_camera = true, .normals_in_camera = true, .wanted = 40},
      {.name = "half, 0..1", .half = true, .normal_stored = encoded, .wanted = 40},
      {.name = "normals in bytes", .normal_stored = in_bytes, .wanted = 40},
      {.name = "normals in bytes, flipped green", .normal_stored = [](const dvec3& n) { return in_bytes(n * dvec3(1, -1, 1)); }, .wanted = 40},
  };
}

/// Waves that tilt normals by 30 degrees on average, but never away from the viewer.
void heavy_bumps(ScenePixel& pixel) {
  const dvec3& p = pixel.position;
  const dvec3 tilted = glm::normalize(pixel.normal + 0.75 * dvec3(std::sin(9 * p.x + 2 * p.y), std::sin(7 * p.y + p.z), std::cos(8 * p.z)));
  if (pixel.id != 0 && glm::dot(tilted, scene_eye - p) > 0.05) pixel.normal = tilted;
}

/// All but a floor, and of the sphere a spot of a few hundred pixels.
void mostly_floor(ScenePixel& pixel) {
  if (pixel.id == 1 && glm::length(glm::dvec2(pixel.position)) > 0.35) pixel = ScenePixel{};
}

TEST(Variations, BumpsAndFloorsHideNoSpace) {
  for (const auto scene : {heavy_bumps, mostly_floor}) {
    const Channels plain = relit({.name = "plain", .scene = scene});
    ASSERT_FALSE(plain.empty());
    for (Variation v : {Variation{.name = "normals in camera space", .normals_in_camera = true},
                        Variation{.name = "flipped green", .normal_stored = [](const dvec3& n) { return n * dvec3(1, -1, 1); }},
                        Variation{.name = "normals z up", .normal_stored = [](const dvec3& n) { return dvec3(n.x, -n.z, n.y); }}}) {
      v.scene = scene;
      const Channels image = relit(v);
      if (image.empty()) continue;
      EXPECT_GE(psnr(image, plain), v.wanted) << v.name << (scene == heavy_bumps ? ", bumps" : ", floor");
    }
  }
}

TEST(Variations, WhatIsNotSureIsSaid) {
  const TemporaryFolder folder;
  Variation v{.name = "noise for normals"};
  v.scene = [](ScenePixel& pixel) {
    const dvec3 p = 1000.0 * pixel.position;
    if (pixel.id != 0) pixel.normal = glm::normalize(dvec3(std::sin(p.x), std::sin(p.y + 1), std::sin(p.z + p.x)));
  };
  write_variation(folder / "in.exr", v);
  write_rig(folder / "rig.json", v);
  const ProgramRun run = run_program(
      {"shade", (folder / "in.exr").string(), "-l", (folder / "rig.json").string(), "-o", (folder / "out.exr").string(), "--device", "twin"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.err.find("warning: normal space is taken to be world, but that is not sure"), std::string::npos) << run.err;
}

/// What inspect says of two walls that meet in a corner, of which the file tells depth alone.
std::string words_on_depth(const std::function<double(double z, double ray)>& stored) {
  constexpr int side = 64;
  constexpr double scale = 80;  // pixels a unit of the tangent
  const auto value = [&](const std::string&, int x, int y) {
    const double u = (x + 0.5 - 0.5 * side) / scale, v = (y + 0.5 - 0.5 * side) / scale, z = 1 / (0.2 + 0.3 * std::abs(u) + 0.1 * v);
    return stored(z, std::sqrt(1 + u * u + v * v));
  };
  const MadeUpExr file({{"", "", {"Z"}}}, side, side, value, [&](Imf::Header& header) {
    header.insert("worldToCamera", Imf::M44fAttribute({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 5, 1}));
    header.insert("CameraFov", Imf::FloatAttribute(float(360 / M_PI * std::atan(0.5 * side / scale))));
  });
  const ProgramRun run = run_program({"inspect", file.file.string()});
  EXPECT_EQ(run.code, 0) << run.err;
  return run.out;
}

TEST(Variations, InverseDepthIsWarnedOf) {
  const auto warned = [](const std::string& words) { return words.find("linear over planes as 1/z would be") != std::string::npos; };
  EXPECT_FALSE(warned(words_on_depth([](double z, double) { return z; })));
  EXPECT_FALSE(warned(words_on_depth([](double z, double ray) { return z * ray; })));
  EXPECT_TRUE(warned(words_on_depth([](double z, double) { return 1 / z; })));
  EXPECT_TRUE(warned(words_on_depth([](double z, double ray) { return 3 / (z * ray); })));
}

TEST(Variations, OnePicture) {
  const Channels plain = relit({.name = "plain"});
  ASSERT_FALSE(plain.empty());
  for (const Variation& v : variations()) {
    const Channels image = relit(v);
    if (image.empty()) continue;
    const double db = psnr(image, plain);
    std::printf("%-50s %6.1f dB, wanted %.0f\n", v.name, db, v.wanted);
    EXPECT_GE(db, v.wanted) << v.name;
  }
}

}  // namespace
}  // namespace relume
