// Culling: lists of lights leave every bit of the picture as it is, on every lane count, and do leave lights out.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "host/light_lists.h"
#include "host/light_records.h"
#include "host/twin.h"

namespace relume {
namespace {

constexpr int width = 150, height = 70;  // rows are no multiple of a block, and the last super-tiles are not full

struct Scene {
  Planes planes{std::size_t(width) * height, 40}, out{std::size_t(width) * height, 3};
  Frame frame{};
  std::vector<LightRecord> lights;
  std::array<int, LIGHT_COUNT + 1> begin{};
};

int constant(Scene& scene, float value) {
  const int plane = scene.planes.add();
  scene.planes.plane(plane)[0] = value;
  return int(scene.planes.stride()) * plane;
}

/// Waves of ground with steps in depth, holes where nothing is seen, and normals of which some look away from the viewer. `apart`: pixels.
void make_pixels(Scene& scene, float facing, float apart) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> some(-1, 1);
  scene.planes.add(7);
  for (int i = 0; i < width * height; ++i) {
    const float x = apart * float(i % width), y = apart * float(i / width);
    const float step = (i % width) / 40 % 2 ? 30 * apart : 0.0f;
    float n[3] = {0.5f * std::sin(x) + 3 * apart * some(random), 1, 0.5f * std::cos(y)};
    // Here and there, or whole cells.
    if (apart < 0.1f ? i % width / 32 % 2 : i % 11 == 3)
      for (float& component : n) component = -component;
    const float length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    const float p[3] = {x, 0.3f * std::sin(2 * x) + step, y};
    for (int c = 0; c < 3; ++c) scene.planes.plane(c)[i] = p[c], scene.planes.plane(3 + c)[i] = n[c] / length;
    scene.planes.plane(6)[i] = i % 17 < 3 ? -1.0f : 0.0f;
  }
  for (std::size_t i = width * height; i < scene.planes.stride(); ++i) scene.planes.plane(6)[i] = -1;
  const int one = constant(scene, 1), face = constant(scene, facing);
  for (Field& field : scene.frame.field) field = {one, 0, 0};
  scene.frame.field[FIELD_facing] = {face, 0, 0};
}

LightRecord light_of(std::mt19937& random, int falloff) {
  std::uniform_real_distribution<float> some(0, 1);
  LightRecord light{};
  const float where[3] = {15 * some(random), 4 * some(random) - 0.5f, 7 * some(random)};
  for (int c = 0; c < 3; ++c) light.position[c] = where[c], light.intensity[c] = some(random), light.direction[c] = some(random) - 0.5f;
  const float length = std::hypot(light.direction[0], light.direction[1], light.direction[2]);
  for (float& d : light.direction) d /= length;
  light.falloff = falloff;
  light.range = 0.3f + some(random);
  light.falloff_scale = falloff_scale(falloff, 0.5f * light.range, light.range);
  light.reach = falloff == FALLOFF_linear || falloff == FALLOFF_windowed ? light.range * 1.0001f : std::numeric_limits<float>::infinity();
  light.outer = 0.8f;
  light.inner = 0.9f;
  return light;
}

void make_lights(Scene& scene, int each) {
  std::mt19937 random(9);
  for (int type = 0; type < LIGHT_COUNT; ++type) {
    scene.begin[std::size_t(type)] = int(scene.lights.size());
    for (int k = 0; k < (type == LIGHT_directional ? 3 : each); ++k)
      scene.lights.push_back(light_of(random, k % 40 ? k % 2 ? FALLOFF_linear : FALLOFF_windowed : FALLOFF_inverse_square));
  }
  scene.begin[LIGHT_COUNT] = int(scene.lights.size());
}

Scene make_scene(float facing, int each, float apart = 0.1f) {
  Scene scene;
  make_pixels(scene, facing, apart);
  make_lights(scene, each);
  Frame& frame = scene.frame;
  frame.pixels = width * height;
  frame.plane_stride = int(scene.planes.stride());
  frame.program_plane = 6;
  frame.normal = 3;
  frame.base_normal = frame.diffuse = frame.specular = frame.ambient_out = -1;
  const float viewer[4] = {7, 9, 12, 1};
  std::memcpy(frame.viewer, viewer, sizeof viewer);
  std::copy(scene.begin.begin(), scene.begin.end(), frame.light_begin);
  scene.out.add(3);
  frame.out_stride = int(scene.out.stride());
  return scene;
}

std::vector<float> shaded(Scene& scene, const LightLists& lists, int lanes) {
  const std::vector<float> tables(1);
  std::fill(scene.out.data(), scene.out.data() + scene.out.bytes() / sizeof(float), -1.0f);
  const auto band = open_twin(lanes)->bind({&scene.planes, scene.lights, lists.numbers(), tables, &scene.out});
  band->shade({DIFFUSE_lambert, SPECULAR_blinn_phong, 0, 0, 0}, scene.frame, {});
  band->finish();
  return {scene.out.data(), scene.out.data() + scene.out.bytes() / sizeof(float)};
}

/// Pixels times lights in the lists.
std::int64_t listed(const LightLists& lists, const Frame& frame) {
  std::int64_t sum = 0;
  for (int block = 0; block < (frame.pixels + RELUME_LISTED_PIXELS - 1) / RELUME_LISTED_PIXELS; ++block) {
    const int* const own = lists.numbers().data() + frame.lists + 2 * block;
    sum += std::int64_t(RELUME_LISTED_PIXELS) * (own[1] - own[0]);
  }
  return sum;
}

class EveryFacing : public testing::TestWithParam<float> {};

TEST_P(EveryFacing, ListsChangeNoBit) {
  for (const std::size_t most : {std::size_t(1) << 24, std::size_t(30'000), std::size_t(9'000)}) {
    Scene scene = make_scene(GetParam(), 300);
    const std::vector<float> all = shaded(scene, {}, 0);
    LightLists lists;
    FrameBounds bounds(scene.planes, scene.frame, width);
    scene.frame.lists = lists.add(bounds, {scene.lights, scene.begin}, most);
    ASSERT_GT(scene.frame.lists, 0) << most;
    EXPECT_LE(lists.numbers().size(), most + 1);
    for (const int lanes : twin_lanes())
      EXPECT_EQ(0, std::memcmp(all.data(), shaded(scene, lists, lanes).data(), all.size() * sizeof(float))) << lanes << " lanes, " << most;
    if (most > 100'000) {
      EXPECT_LT(listed(lists, scene.frame), std::int64_t(width) * height * std::int64_t(scene.lights.size()) / 5);
    }
  }
}

/// Cells are nearly points here, so that bounds are nearly what pixels are, and a test that says no too soon is found out.
TEST_P(EveryFacing, ListsOfSmallCellsChangeNoBit) {
  Scene scene = make_scene(GetParam(), 2000, 1e-4f);
  std::mt19937 random(3);
  std::uniform_real_distribution<float> some(-1, 1);
  for (LightRecord& light : scene.lights)
    for (float& place : light.position) place = some(random);
  const std::vector<float> all = shaded(scene, {}, 0);
  LightLists lists;
  FrameBounds bounds(scene.planes, scene.frame, width);
  scene.frame.lists = lists.add(bounds, {scene.lights, scene.begin}, std::size_t(1) << 26);
  ASSERT_GT(scene.frame.lists, 0);
  EXPECT_EQ(0, std::memcmp(all.data(), shaded(scene, lists, 0).data(), all.size() * sizeof(float)));
  EXPECT_LT(listed(lists, scene.frame), std::int64_t(width) * height * std::int64_t(scene.lights.size()) / 5);
}

INSTANTIATE_TEST_SUITE_P(LightLists, EveryFacing, testing::Values(FACING_as_stored, FACING_one_sided, FACING_two_sided));

TEST(LightLists, NothingIsListedWhereNothingCanBeCulledOrKept) {
  Scene scene = make_scene(FACING_as_stored, 300);
  LightLists lists;
  FrameBounds bounds(scene.planes, scene.frame, width);
  EXPECT_EQ(lists.add(bounds, {scene.lights, scene.begin}, 100), 0);  // no room
  for (LightRecord& light : scene.lights) light.reach = std::numeric_limits<float>::infinity();
  EXPECT_EQ(lists.add(bounds, {scene.lights, scene.begin}, std::size_t(1) << 24), 0);
}

TEST(LightLists, LightsBetweenTheSidesOfAStepInDepthAreListedForNeither) {
  Scene scene = make_scene(FACING_as_stored, 300);
  LightRecord light = scene.lights[std::size_t(scene.begin[LIGHT_point]) + 1];
  ASSERT_EQ(light.falloff, FALLOFF_linear);
  light.range = 0.6f;
  light.falloff_scale = falloff_scale(light.falloff, 0.3f, light.range);
  light.reach = light.range * 1.0001f;
  scene.lights.clear();
  for (int k = 0; k < 20; ++k) {
    // Above the low ground, below the high, where columns 40 and 80 step from one to the other.
    light.position[0] = k % 2 ? 4.0f : 8.0f, light.position[1] = 1.5f, light.position[2] = 0.3f * float(k);
    scene.lights.push_back(light);
  }
  scene.begin = {0, 0, 20, 20};
  std::copy(scene.begin.begin(), scene.begin.end(), scene.frame.light_begin);
  LightLists lists;
  FrameBounds bounds(scene.planes, scene.frame, width);
  scene.frame.lists = lists.add(bounds, {scene.lights, scene.begin}, std::size_t(1) << 24);
  ASSERT_GT(scene.frame.lists, 0);
  EXPECT_EQ(listed(lists, scene.frame), 0);
}

TEST(LightLists, ListsDoNotDependOnWhatWasListedBefore) {
  Scene scene = make_scene(FACING_two_sided, 300);
  const SortedLights lights(scene.lights, scene.begin);
  std::vector<LightRecord> wide = scene.lights;
  for (LightRecord& light : wide) light.reach *= 8;
  const SortedLights others(wide, scene.begin), few(std::span(scene.lights), std::array{0, 3, 40, 40});
  ASSERT_NE(lights.widest_box, others.widest_box);
  LightLists again;
  FrameBounds held(scene.planes, scene.frame, width);
  for (const SortedLights* now : {&lights, &others, &few, &lights}) {
    again.clear();
    LightLists fresh;
    FrameBounds bounds(scene.planes, scene.frame, width);
    EXPECT_EQ(again.add(held, *now, std::size_t(1) << 24), fresh.add(bounds, *now, std::size_t(1) << 24));
    EXPECT_TRUE(std::equal(again.numbers().begin() + 1, again.numbers().end(), fresh.numbers().begin() + 1, fresh.numbers().end()));
  }
}

TEST(LightLists, AFrameThatShowsNothingHasEmptyLists) {
  Scene scene = make_scene(FACING_as_stored, 300);
  std::fill(scene.planes.plane(6), scene.planes.plane(7), -1.0f);
  LightLists lists;
  FrameBounds bounds(scene.planes, scene.frame, width);
  scene.frame.lists = lists.add(bounds, {scene.lights, scene.begin}, std::size_t(1) << 24);
  ASSERT_GT(scene.frame.lists, 0);
  EXPECT_EQ(listed(lists, scene.frame), 0);
}

}  // namespace
}  // namespace relume
