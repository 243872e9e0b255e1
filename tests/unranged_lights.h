// Pixels, lobes and rigs of unranged lights for tests of the light tree.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <ostream>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "host/device.h"
#include "host/twin.h"

namespace relume {

constexpr int width = 72, height = 40;  // rows are no multiple of a block

using Random = std::mt19937;
inline float between(Random& random, float low, float high) { return std::uniform_real_distribution<float>(low, high)(random); }

/// Lobes and the parameters that they are to have; the others are 1.
struct Look {
  const char* name;
  Choice choice;
  std::vector<std::pair<int, float>> parameters;
};

/// Where lights are, and how they differ.
struct Placing {
  const char* name;
  std::function<void(Random&, LightRecord&)> place;
};

struct UnrangedScene {
  Planes planes{std::size_t(width) * height, 40}, out{std::size_t(width) * height, 9};
  Frame frame{};
  std::vector<LightRecord> lights;
  std::array<int, LIGHT_COUNT + 1> begin{};
  std::vector<Choice> programs;
  std::vector<float> tables = std::vector<float>(1);
};

/// Rolling ground with a wall behind a step in depth, holes, and a checkered albedo.
inline void make_pixels(UnrangedScene& scene) {
  scene.planes.add(10);
  for (int i = 0; i < width * height; ++i) {
    const float x = 0.05f * float(i % width) - 2, z = 0.05f * float(i / width) - 1;
    const bool wall = i % width > 50;
    float n[3] = {0.2f * std::sin(x), 1, 0.3f * std::cos(z)};
    if (wall) n[0] = -1, n[1] = 0.1f, n[2] = 0;
    const float length = std::hypot(n[0], n[1], n[2]);
    const float p[3] = {wall ? 2.0f : x, wall ? 1 + x : 0.2f * std::cos(x) - 0.3f * std::sin(z), z};
    for (int c = 0; c < 3; ++c) {
      scene.planes.plane(c)[i] = p[c], scene.planes.plane(3 + c)[i] = n[c] / length;
      scene.planes.plane(7 + c)[i] = c == 1 && i % 5 == 0 ? 0.0f : (i / 3 + i / width / 3) % 2 ? 0.8f : 0.1f;
    }
    scene.planes.plane(6)[i] = i % 23 == 0 ? -1.0f : 0.0f;
  }
  for (std::size_t i = width * height; i < scene.planes.stride(); ++i) scene.planes.plane(6)[i] = -1;
}

inline void set_field(UnrangedScene& scene, int field, float value) {
  const int plane = scene.planes.add();
  scene.planes.plane(plane)[0] = value;
  scene.frame.field[field] = {int(scene.planes.stride()) * plane, 0, 0};
}

inline UnrangedScene make_scene(const Look& look, const Placing& rig, int lights) {
  UnrangedScene scene;
  make_pixels(scene);
  Frame& frame = scene.frame;
  set_field(scene, 0, 1);
  std::fill(std::begin(frame.field), std::end(frame.field), frame.field[0]);
  set_field(scene, FIELD_facing, FACING_one_sided);
  for (const auto& [field, value] : look.parameters) set_field(scene, field, value);
  const int stride = int(scene.planes.stride());
  frame.field[FIELD_albedo] = frame.field[FIELD_kd] = {7 * stride, 1, stride};
  frame.pixels = width * height, frame.plane_stride = stride, frame.program_plane = 6, frame.normal = 3;
  frame.base_normal = frame.diffuse = frame.specular = frame.ambient_out = -1;
  frame.viewer[1] = 6, frame.viewer[2] = 12, frame.viewer[3] = 1;
  Random random(11);
  for (int k = 0; k < lights; ++k) {
    LightRecord& light = scene.lights.emplace_back();
    for (float& i : light.intensity) i = 1;
    rig.place(random, light);
    light.falloff = FALLOFF_inverse_square;
    light.reach = std::numeric_limits<float>::infinity();
  }
  for (int type = 0; type <= LIGHT_COUNT; ++type) scene.begin[std::size_t(type)] = type <= LIGHT_point ? 0 : lights;
  std::copy(scene.begin.begin(), scene.begin.end(), frame.light_begin);
  scene.out.add(9);
  frame.out_stride = int(scene.out.stride());
  scene.programs = {look.choice};
  return scene;
}

inline std::vector<float> shaded(UnrangedScene& scene, const Frame& frame, std::span<const int> lists) {
  const auto band = open_twin()->bind({&scene.planes, scene.lights, lists, scene.tables, &scene.out});
  band->shade(scene.programs[0], frame, {});
  band->finish();
  return {scene.out.data(), scene.out.data() + scene.out.bytes() / sizeof(float)};
}

inline void somewhere(Random& random, LightRecord& light, float low, float high) {
  light.position[0] = between(random, -12, 8), light.position[1] = between(random, low, high), light.position[2] = between(random, -9, 9);
}

inline void coloured(Random& random, LightRecord& light) {
  for (float& i : light.intensity) i = between(random, 0, 1) < 0.4f ? 0 : between(random, 0, 3);
}

inline const Look looks[] = {
    {"lambert", {DIFFUSE_lambert, SPECULAR_none, 0, 0, 0}, {}},
    {"rough_ggx",
     {DIFFUSE_lambert, SPECULAR_ggx, FRESNEL_schlick, SHADOWING_smith, 0},
     {{FIELD_alpha, 0.4f}, {FIELD_f0, 0.04f}, {FIELD_metallic, 0}}},
    {"sharp_ggx",
     {DIFFUSE_lambert, SPECULAR_ggx, FRESNEL_schlick, SHADOWING_smith, 0},
     {{FIELD_alpha, 0.03f}, {FIELD_f0, 0.04f}, {FIELD_metallic, 0}}},
    {"metal", {DIFFUSE_none, SPECULAR_ggx, FRESNEL_schlick, SHADOWING_smith, 0}, {{FIELD_alpha, 0.3f}, {FIELD_f0, 0.9f}, {FIELD_metallic, 0}}},
    {"cook_torrance",
     {DIFFUSE_lambert, SPECULAR_cook_torrance, FRESNEL_schlick, SHADOWING_v_groove, 0},
     {{FIELD_alpha, 0.25f}, {FIELD_f0, 0.3f}, {FIELD_metallic, 0}}},
    {"blinn_phong", {DIFFUSE_lambert_original, SPECULAR_blinn_phong, 0, 0, 0}, {{FIELD_ks, 0.3f}, {FIELD_exponent, 40}}},
    {"phong", {DIFFUSE_oren_nayar, SPECULAR_phong, 0, 0, 0}, {{FIELD_ks, 0.3f}, {FIELD_exponent, 20}, {FIELD_sigma, 0.5f}}},
    {"burley",
     {DIFFUSE_burley, SPECULAR_principled, 0, 0, 0},
     {{FIELD_roughness, 0.6f}, {FIELD_metallic, 0}, {FIELD_ior, 1.5f}, {FIELD_spec_tint, 0}, {FIELD_clearcoat, 0}}},
};

inline const Placing rigs[] = {
    {"volume", [](Random& r, LightRecord& l) { somewhere(r, l, 0.5f, 12); }},
    {"coloured_volume", [](Random& r, LightRecord& l) { somewhere(r, l, 0.5f, 12), coloured(r, l); }},
    {"plane", [](Random& r, LightRecord& l) { somewhere(r, l, 4, 4); }},
    {"near_the_ground", [](Random& r, LightRecord& l) { somewhere(r, l, -0.5f, 0.6f), coloured(r, l); }},  // some below it: on the horizon
    {"clumps",
     [](Random& r, LightRecord& l) {
       const float clump = std::floor(between(r, 0, 9));
       for (int c = 0; c < 3; ++c) l.position[c] = 3 * std::sin(clump * float(c + 2)) + between(r, -0.3f, 0.3f);
       l.position[1] += 4, l.intensity[0] = 1 + clump, l.intensity[1] = 9 - clump;
     }},
    {"one_place", [](Random&, LightRecord& l) { l.position[1] = 3; }},
};

struct Case {
  const Look* look;
  const Placing* rig;
};
inline void PrintTo(const Case& c, std::ostream* out) { *out << c.look->name << "_" << c.rig->name; }

inline std::vector<Case> every_case() {
  std::vector<Case> cases;
  for (const Look& look : looks)
    for (const Placing& rig : rigs) cases.push_back({&look, &rig});
  return cases;
}

}  // namespace relume
