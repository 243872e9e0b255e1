// shade_test_band: the planes, lights and tables of the made-up band.
#include "host/test_band.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include "host/ambient_nodes.h"
#include "host/device_environment.h"
#include "host/light_records.h"
#include "host/merl_numbers.h"
#include "kernels/cycles_tables.h"

namespace relume {
namespace {

/// Planes: position 0-2, normal 3-5, program 6, one more for each parameter's component.
struct TestBand {
  int pixels;
  Planes planes{std::size_t(pixels), 9 + 3 * FIELD_COUNT};
  Frame frame{};
  std::vector<LightRecord> lights{};
  std::vector<float> tables{};
  std::size_t measured = 0;  // where a measured BRDF starts in the tables
};

struct Limits {
  double low, high;
};

/// Alpha 0.05 is roughness 0.2236, the exponent 2/alpha^2 - 2 = 798, and the gloss of principled's clearcoat, whose alpha goes from 0.1 to 0.001.
Limits limits_of(int field, TestRange range, Limits all) {
  if (range == TestRange::whole) return all;
  switch (field) {
    case FIELD_alpha:
      return {0.05, all.high};
    case FIELD_roughness:
      return {0.2236, all.high};
    case FIELD_exponent:
      return {all.low, 798};
    case FIELD_clearcoat_gloss:
      return {all.low, 0.5};
    case FIELD_fdr:
      return {all.low, 0.96};  // the most that host/rough_transmittance gives, at ior 4
    default:
      return all;
  }
}

void place_field(TestBand& band, int field, int components, std::mt19937& random, Limits limits) {
  const int first = band.planes.add(components);
  const float low = float(limits.low), high = float(limits.high);
  std::uniform_real_distribution<float> value{low, high};
  for (int c = 0; c < components; ++c)
    for (int i = 0; i < band.pixels; ++i) band.planes.plane(first + c)[i] = i % 7 == 3 ? low : i % 7 == 5 ? high : value(random);
  band.frame.field[field] = {int(band.planes.stride()) * first, 1, int(band.planes.stride())};
}

void place_constant(TestBand& band, int field, float constant) {
  const int first = band.planes.add();
  band.planes.plane(first)[0] = constant;
  band.frame.field[field] = {int(band.planes.stride()) * first, 0, 0};
}

/// A third of the pixels have a table of their own: the first entries of Cycles' will do. Two thirds have a measured BRDF.
void place_table_starts(TestBand& band) {
  const int first = band.planes.add();
  for (int i = 0; i < band.pixels; ++i) band.planes.plane(first)[i] = i % 3 == 1 ? 0.0f : -1.0f;
  band.frame.field[FIELD_transmittance] = {int(band.planes.stride()) * first, 1, 0};
  const int measured = band.planes.add();
  for (int i = 0; i < band.pixels; ++i) band.planes.plane(measured)[i] = i % 3 == 2 ? -1.0f : float(band.measured);
  band.frame.field[FIELD_table] = {int(band.planes.stride()) * measured, 1, 0};
}

void make_lights(TestBand& band) {
  LightRecord light{};
  const float values[3] = {7, 11, 13}, towards[3] = {-0.6f, 0.0f, -0.8f}, where[3] = {2, 1, 3};
  std::memcpy(light.intensity, values, sizeof values);
  std::memcpy(light.direction, towards, sizeof towards);
  std::memcpy(light.position, where, sizeof where);
  light.range = 6;
  light.inner = 0.97f;
  light.outer = 0.6f;
  const int falloffs[] = {FALLOFF_inverse_square, FALLOFF_windowed, FALLOFF_linear, FALLOFF_none};
  for (int type = 0; type < LIGHT_COUNT; ++type) {
    band.frame.light_begin[type] = int(band.lights.size());
    for (int k = 0; k < 4; ++k) {
      light.falloff = falloffs[k];
      light.falloff_scale = falloff_scale(falloffs[k], 1, light.range);
      light.cone = k % 3;
      light.position[k % 3] -= 0.7f;
      if (light.cone == CONE_linear) light.inner = 0.2f, light.outer = 0.9f;
      band.lights.push_back(light);
    }
  }
  band.frame.light_begin[LIGHT_COUNT] = int(band.lights.size());
}

void make_pixels(TestBand& band, std::mt19937& random) {
  std::normal_distribution<float> any;
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  for (int i = 0; i < band.pixels; ++i) {
    float n[3] = {any(random), any(random), any(random) + 2};
    const float length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (int c = 0; c < 3; ++c) {
      band.planes.plane(c)[i] = any(random);
      band.planes.plane(3 + c)[i] = i == 10 ? 0 : i == 11 ? nan : n[c] / length;
    }
    if (i == 12) band.planes.plane(0)[i] = nan;
    if (i == 13) band.planes.plane(1)[i] = infinity;
  }
  for (int c = 0; c < 3; ++c) band.planes.plane(c)[14] = band.lights[std::size_t(band.frame.light_begin[LIGHT_point])].position[c];
  for (int i = 0; i < int(band.planes.stride()); ++i) band.planes.plane(6)[i] = i < band.pixels ? 0.0f : -1.0f;
}

/// Cycles' tables stand first (any numbers do here), then ambient's nodes, then a measured BRDF.
void make_tables(TestBand& band) {
  for (int i = 0; i < RELUME_CYCLES_TABLES_LENGTH; ++i) band.tables.push_back(0.5f + 0.5f * float(i % 37) / 37);
  const std::vector<float> nodes = ambient_nodes();
  band.frame.nodes = int(band.tables.size());
  band.frame.node_count = int(nodes.size() / 4);
  band.tables.insert(band.tables.end(), nodes.begin(), nodes.end());
  band.measured = band.tables.size();
  const std::vector<float> measured = merl_numbers(stand_in_table(9, 5, 6));
  band.tables.insert(band.tables.end(), measured.begin(), measured.end());
}

/// A bright texel among dim ones, and the frame turned out of every axis.
void make_environment(TestBand& band) {
  constexpr int width = 12, height = 6, samples = 16;
  std::vector<std::array<float, 3>> radiance;
  for (int i = 0; i < width * height; ++i) radiance.push_back({0.1f * float(i % 5), 0.2f, i == 17 ? 300.0f : 0.05f * float(i % 11)});
  const DeviceEnvironment environment{environment_of(width, height, radiance, environment_mappings().back(), "self-test"),
                                      glm::dmat3(0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6)};
  band.frame.environment = place_sampled(environment, samples, band.tables);
  // Any numbers do for what is looked up.
  band.frame.environment.levels = 2;
  band.frame.environment.level = place_image(environment.map, band.tables);
  place_image(environment.map, band.tables);
  band.frame.environment.harmonics = int(band.tables.size());
  for (int k = 0; k < 27; ++k) band.tables.push_back(1 - 0.09f * float(k));
  band.frame.environment.scramble = band.planes.add(2);
  for (int plane = 0; plane < 2; ++plane)
    for (int i = 0; i < band.pixels; ++i) band.planes.plane(band.frame.environment.scramble + plane)[i] = scrambled(i, 0, 0, unsigned(plane));
}

TestBand make_band(TestRange range, int pixels) {
  TestBand band{pixels};
  std::mt19937 random(20241122);
  band.planes.add(7);
  make_tables(band);
  make_lights(band);
  make_pixels(band, random);
#define RELUME_PLACE(name, components, fallback, lowest, highest, meaning) \
  place_field(band, FIELD_##name, components, random, limits_of(FIELD_##name, range, {lowest, highest}));
  RELUME_PARAMETERS(RELUME_PLACE)
#undef RELUME_PLACE
  place_table_starts(band);
  place_constant(band, FIELD_coverage, 1);
  place_constant(band, FIELD_facing, FACING_as_stored);
  Frame& frame = band.frame;
  frame.pixels = band.pixels;
  frame.plane_stride = int(band.planes.stride());
  frame.program_plane = 6;
  frame.normal = 3;
  frame.base_normal = -1;
  const float viewer[4] = {0.3f, -0.4f, 5, 1}, ambient[4] = {0.1f, 0.2f, 0.3f, 1};
  std::memcpy(frame.viewer, viewer, sizeof viewer);
  std::memcpy(frame.ambient, ambient, sizeof ambient);
  frame.total = 0;
  frame.diffuse = 3;
  frame.specular = 6;
  frame.ambient_out = 9;
  return band;
}

}  // namespace

Planes shade_test_band(Device& device, const Choice& choice, TestRange range, int pixels) {
  TestBand band = make_band(range, pixels);
  Planes out(std::size_t(pixels), test_planes);
  out.add(test_planes);
  band.frame.out_stride = int(out.stride());
  const auto bound = device.bind({&band.planes, band.lights, {}, band.tables, &out});
  bound->shade(choice, band.frame, {});
  bound->finish();
  return out;
}

Planes light_test_band(Device& device, const Choice& choice, Entry environment, TestRange range, int pixels) {
  TestBand band = make_band(range, pixels);
  Planes out(std::size_t(pixels), test_planes);
  out.add(test_planes);
  band.frame.out_stride = int(out.stride());
  band.frame.error = band.frame.ambient_out;
  make_environment(band);
  const auto bound = device.bind({&band.planes, band.lights, {}, band.tables, &out});
  bound->add_environment(environment, choice, band.frame, {});
  bound->finish();
  return out;
}

double test_difference(float a, float b) {
  const double difference = std::fabs(double(a) - double(b)) / std::max({std::fabs(double(a)), std::fabs(double(b)), 1e-3});
  return difference == difference ? difference : std::numeric_limits<double>::infinity();
}

}  // namespace relume
