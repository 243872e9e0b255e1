// A rig's lights as the kernels read them: by type, in the rig's order, and where there are thousands with neighbours together.
#include "host/light_records.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace relume {
namespace {

std::vector<Light> scattered(int count) {
  std::mt19937 random(11);
  std::uniform_real_distribution<> in(-50, 50);
  std::vector<Light> lights(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) {
    Light& light = lights[std::size_t(k)];
    light.name = std::to_string(k);
    light.type = k % 3 == 0 ? LightType::spot : LightType::point;
    light.position = {in(random), in(random), in(random)};
    light.direction = {0, -1, 0};
  }
  return lights;
}

double distance(const LightRecord& a, const LightRecord& b) {
  return std::hypot(a.position[0] - b.position[0], a.position[1] - b.position[1], a.position[2] - b.position[2]);
}

double mean_step(const LightRecords& r, int type) {
  double sum = 0;
  const int begin = r.begin[std::size_t(type)], end = r.begin[std::size_t(type) + 1];
  for (int k = begin + 1; k < end; ++k) sum += distance(r.records[std::size_t(k - 1)], r.records[std::size_t(k)]);
  return sum / (end - begin - 1);
}

/// Each light of the rig once, where its type is, and as it was.
void expect_all_of(const std::vector<Light>& lights, const LightRecords& r) {
  ASSERT_EQ(r.records.size(), lights.size());
  ASSERT_EQ(r.lights.size(), lights.size());
  std::vector<int> seen(lights.size());
  for (std::size_t k = 0; k < r.lights.size(); ++k) {
    EXPECT_EQ(r.lights[k].begin, int(k));
    EXPECT_EQ(r.lights[k].end, int(k) + 1);
    const std::size_t number = std::stoul(r.lights[k].name);
    ++seen[number];
    for (int c = 0; c < 3; ++c) EXPECT_EQ(r.records[k].position[c], float(lights[number].position[c]));
    const std::size_t type = std::size_t(lights[number].type);
    EXPECT_TRUE(r.begin[type] <= int(k) && int(k) < r.begin[type + 1]);
  }
  EXPECT_EQ(seen, std::vector<int>(lights.size(), 1));
}

TEST(LightRecords, FewKeepTheRigsOrder) {
  const std::vector<Light> lights = scattered(300);
  const LightRecords r = light_records(lights);
  expect_all_of(lights, r);
  for (int type : {LIGHT_point, LIGHT_spot})
    for (int k = r.begin[std::size_t(type)] + 1; k < r.begin[std::size_t(type) + 1]; ++k)
      EXPECT_LT(std::stoi(r.lights[std::size_t(k - 1)].name), std::stoi(r.lights[std::size_t(k)].name));
}

TEST(LightRecords, OfThousandsNeighboursAreTogether) {
  const std::vector<Light> lights = scattered(30'000);
  const LightRecords r = light_records(lights);
  expect_all_of(lights, r);
  // In a cube of side 100: 20,000 points are 100/27 apart, two random ones 66.
  EXPECT_LT(mean_step(r, LIGHT_point), 2 * 100.0 / 27);
  EXPECT_LT(mean_step(r, LIGHT_spot), 2 * 100.0 / 21);
}

TEST(LightRecords, ThousandsInOnePlaceKeepTheRigsOrder) {
  std::vector<Light> lights = scattered(30'000);
  for (Light& light : lights) light.position = {1, 2, 3}, light.type = LightType::point;
  const LightRecords r = light_records(lights);
  expect_all_of(lights, r);
  for (std::size_t k = 0; k < lights.size(); ++k) EXPECT_EQ(r.lights[k].name, lights[k].name);
}

}  // namespace
}  // namespace relume
