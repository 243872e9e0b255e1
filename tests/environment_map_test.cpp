// Environment maps: each tool's mapping by its own formula, solid angles, samples' density, median cut, and what is refused.
#include "host/environment_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <random>

#include "host/device_environment.h"
#include "host/median_cut.h"
#include "tests/kernel_lanes.h"
#include "tests/made_up_exr.h"
#include "tests/refusal.h"

namespace relume {
namespace kernel {
#include "kernels/environment/draw.h"
}
namespace {

constexpr double pi = std::numbers::pi;
using Texels = std::vector<std::array<float, 3>>;

Texels grey_texels(int width, int height, float value = 1) {
  return Texels(std::size_t(width) * std::size_t(height), std::array<float, 3>{value, value, value});
}

const EnvironmentMapping& mapping_named(const std::string& name) {
  for (const EnvironmentMapping& mapping : environment_mappings())
    if (mapping.name == name) return mapping;
  throw std::runtime_error("no mapping " + name);
}

/// Where a direction of the tool's space falls, in texels from the centre of the first: from the tool's own document or source.
struct Pixel {
  double x, y;
};
Pixel openexr(const glm::dvec3& d, int w, int h) {  // ImfEnvmap.cpp, LatLongMap::pixelPosition
  const double latitude = std::asin(d.y), longitude = std::atan2(d.x, d.z);
  return {(longitude / (-2 * pi) + 0.5) * (w - 1), (latitude / -pi + 0.5) * (h - 1)};
}
Pixel mitsuba(const glm::dvec3& d, int w, int h) {  // envmap.cpp: u = atan2(x, -z)/2 pi, v = acos(y)/pi
  const double u = std::atan2(d.x, -d.z) / (2 * pi);
  return {(u - std::floor(u)) * w - 0.5, std::acos(d.y) / pi * (h - 1)};
}
Pixel blender(const glm::dvec3& d, int w, int h) {  // Cycles, projection.h: direction_to_equirectangular
  return {(0.5 - std::atan2(d.y, d.x) / (2 * pi)) * w - 0.5, (0.5 - std::asin(d.z) / pi) * h - 0.5};
}
Pixel oiio_y_up(const glm::dvec3& d, int w, int h) {  // OpenImageIO, environment.cpp: vector_to_latlong
  return {(std::atan2(-d.x, d.z) / (2 * pi) + 0.5) * w - 0.5, (0.5 - std::atan2(d.y, std::hypot(d.x, d.z)) / pi) * h - 0.5};
}
Pixel oiio_z_up(const glm::dvec3& d, int w, int h) {
  return {(std::atan2(d.y, d.x) / (2 * pi) + 0.5) * w - 0.5, (0.5 - std::atan2(d.z, std::hypot(d.x, d.y)) / pi) * h - 0.5};
}
Pixel materialx(const glm::dvec3& d, int w, int h) {  // mx_latlong_projection
  return {(std::atan2(d.x, -d.z) / (2 * pi) + 0.5) * w - 0.5, (0.5 - std::asin(d.y) / pi) * h - 0.5};
}

const std::map<std::string, Pixel (*)(const glm::dvec3&, int, int)> tools{{"openexr", openexr},    {"usdlux", openexr},      {"mitsuba", mitsuba},
                                                                          {"blender", blender},    {"oiio_y_up", oiio_y_up}, {"oiio_z_up", oiio_z_up},
                                                                          {"materialx", materialx}};

TEST(EnvironmentMap, TexelsLookWhereEachToolSaysTheyDo) {
  constexpr int width = 24, height = 12;
  for (const EnvironmentMapping& mapping : environment_mappings()) {
    ASSERT_TRUE(tools.contains(std::string(mapping.name))) << mapping.name << " needs its tool's formula here";
    const EnvironmentMap map = environment_of(width, height, grey_texels(width, height), mapping, "test");
    for (int i = 0; i < map.height; ++i)
      for (int j = 0; j < map.width; ++j) {
        const glm::dvec3 direction = mapping.light_from_map * map.direction(i, j);
        const Pixel pixel = tools.at(std::string(mapping.name))(direction, width, height);
        EXPECT_NEAR(pixel.y, i, 1e-6) << mapping.name;      // asin near a pole
        if (std::sin(map.polar_angle(i)) < 1e-9) continue;  // a pole has every azimuth
        const double period = map.columns_on_border ? width - 1 : width;
        EXPECT_NEAR(std::remainder(pixel.x - j, period), 0, 1e-9) << mapping.name << " " << i << " " << j;
      }
  }
}

TEST(EnvironmentMap, SolidAnglesAreAWholeSphere) {
  for (const EnvironmentMapping& mapping : environment_mappings())
    for (const int height : {1, 2, 3, 64, 513}) {
      const EnvironmentMap map = environment_of(2 * height, height, grey_texels(2 * height, height), mapping, "test");
      double sum = 0;
      for (const double angle : map.solid_angles()) {
        EXPECT_GT(angle, 0);
        sum += angle * map.width;
      }
      EXPECT_NEAR(sum, 4 * pi, 1e-9) << mapping.name << " " << height;
    }
}

/// Lively, and black in places.
EnvironmentMap lively_map(const EnvironmentMapping& mapping, int width = 32, int height = 16) {
  Texels texels;
  for (int k = 0; k < width * height; ++k) texels.push_back({k == 133 ? 60.0f : 0.1f * float(k % 7), k % 5 ? 0.2f : 0.0f, 0.05f * float(k % 11)});
  return environment_of(width, height, texels, mapping, "test");
}

/// The density of samples is known: the mean of any function over it is that function's integral. Here of 1 (where the map is not black), of the
/// radiance and of the direction times it, against sums over texels.
TEST(EnvironmentMap, SamplesHaveTheDensityThatTheySay) {
  for (const char* name : {"openexr", "mitsuba", "blender"}) {
    const EnvironmentMapping& mapping = mapping_named(name);
    const EnvironmentMap map = lively_map(mapping);
    std::vector<float> tables;
    Frame frame{};
    frame.environment = place_sampled({map, mapping.light_from_map}, 16, tables);
    glm::dvec3 mean(0), towards(0), sum(0), towards_sum(0);
    constexpr int samples = 2'000'000;
    std::mt19937 random(7);
    std::uniform_real_distribution<float> any;
    for (int k = 0; k < samples; ++k) {
      float cosine = 0;
      const kernel::MapPlace place = kernel::draw_place(&frame.environment, tables.data(), any(random), any(random), &cosine);
      const kernel::real3 l = kernel::direction_at(&frame.environment.image, frame.environment.world_from_map, place, cosine);
      const kernel::Incoming in = kernel::incoming_at(&frame.environment, tables.data(), place);
      const kernel::Incoming again =
          kernel::incoming_at(&frame.environment, tables.data(), kernel::place_of(&frame.environment.image, frame.environment.world_from_map, l));
      if (place.sine > 0.01f) {
        ASSERT_NEAR(again.density, in.density, 5e-3 * in.density + 1e-4);
      }
      const glm::dvec3 share = glm::dvec3(in.radiance.x, in.radiance.y, in.radiance.z) / double(in.density);
      mean += share / double(samples);
      towards += share.x / double(samples) * glm::dvec3(l.x, l.y, l.z);
    }
    for (const DirectedIrradiance& texel : texel_irradiances(map)) {
      sum += texel.irradiance;
      towards_sum += texel.irradiance.x * (mapping.light_from_map * texel.direction);
    }
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(mean[c], sum[c], 4e-3 * sum[c]) << name;
      EXPECT_NEAR(towards[c], towards_sum[c], 1e-2 * sum.x) << name;  // a texel's own width, of 11 degrees, shortens the mean direction
    }
  }
}

TEST(MedianCut, KeepsTheEnergyAndSharesItOut) {
  const EnvironmentMap map = lively_map(environment_mappings()[0]);
  glm::dvec3 all(0);
  for (const DirectedIrradiance& texel : texel_irradiances(map)) all += texel.irradiance;
  for (const int lights : {1, 2, 64, 100, 100000}) {
    const std::vector<DirectedIrradiance> cut = median_cut(map, lights);
    EXPECT_LE(int(cut.size()), lights);
    glm::dvec3 sum(0);
    for (const DirectedIrradiance& light : cut) {
      sum += light.irradiance;
      EXPECT_NEAR(glm::length(light.direction), 1, 1e-12);
    }
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c], all[c], 1e-9 * all[c]);
  }
  EXPECT_EQ(median_cut(map, 100000).size(), texel_irradiances(map).size());
  const std::vector<DirectedIrradiance> even = median_cut(environment_of(256, 128, grey_texels(256, 128), environment_mappings()[3], "test"), 64);
  ASSERT_EQ(even.size(), 64u);
  for (const DirectedIrradiance& light : even) EXPECT_NEAR(light.irradiance.x, 4 * pi / 64, 0.5 * 4 * pi / 64);  // whole texels
}

TEST(EnvironmentMap, ReadsGreyAndLayeredImages) {
  const MadeUpExr grey({{"", "", {"Y"}}}, 8, 4, [](const std::string&, int x, int y) { return x + 10 * y; });
  const MadeUpExr layered({{"", "", {"Sky.R", "Sky.G", "Sky.B", "A"}}}, 8, 4,
                          [](const std::string& c, int, int) { return c == "Sky.G" ? 2.0 : 1.0; });
  const EnvironmentMap first = read_environment(grey.file, mapping_named("blender")),
                       second = read_environment(layered.file, mapping_named("blender"));
  EXPECT_EQ(first.radiance[11], (std::array<float, 3>{13, 13, 13}));
  EXPECT_EQ(second.radiance[11], (std::array<float, 3>{1, 2, 1}));
}

TEST(EnvironmentMap, RefusesWhatIsNone) {
  const EnvironmentMapping& mapping = environment_mappings()[0];
  const auto refusal = [&](int width, int height, float value) {
    Texels texels = grey_texels(width, height);
    texels[std::size_t(width) + 2][1] = value;
    return error_of([&] { environment_of(width, height, texels, mapping, "sky.exr"); });
  };
  EXPECT_EQ(refusal(8, 4, 1), "no error");
  EXPECT_EQ(refusal(4, 24, 1),
            "sky.exr: 4x24 is no latitude-longitude image (about twice as wide as high; six faces or a mirrored ball are to be converted)");
  EXPECT_EQ(refusal(8, 4, std::nanf("")),
            "sky.exr: the radiance of texel 2, 1 is NaN (numbers from 0 to 3.4e38 are radiance; oiiotool --fixnan, --clamp mend a file)");
  EXPECT_NE(refusal(8, 4, -0.5f).find("texel 2, 1 is negative (-0.5)"), std::string::npos);
  EXPECT_NE(refusal(8, 4, INFINITY).find("texel 2, 1 is infinite"), std::string::npos);
  EXPECT_NE(error_of([&] { read_environment("/nowhere/sky.exr", mapping); }).find("/nowhere/sky.exr"), std::string::npos);
  EXPECT_NE(error_of([&] { read_environment("/nowhere/sky.hdr", mapping); }).find("/nowhere/sky.hdr"), std::string::npos);
  const MadeUpExr depth({{"", "", {"Z", "id"}}}, 8, 4, [](const std::string&, int, int) { return 1.0; });
  EXPECT_NE(error_of([&] { read_environment(depth.file, mapping); }).find("an environment has channels R, G, B"), std::string::npos);
}

}  // namespace
}  // namespace relume
