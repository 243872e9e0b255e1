// What each light sends to a point, and what a bump lets through: the formulas of FORMATS.md by hand.
#include <gtest/gtest.h>

#include "tests/kernel_lanes.h"

namespace relume {
namespace {

constexpr double kPi = 3.14159265358979323846;

kernel::LightRecord light_at(float x, float y, float z) {
  kernel::LightRecord light{};
  light.position[0] = x;
  light.position[1] = y;
  light.position[2] = z;
  light.direction[2] = -1;
  return light;
}

const kernel::real3 kOrigin = kernel::real3_of(0.0f, 0.0f, 0.0f);

double share(const kernel::LightRecord& light) { return kernel::light_spot(&light, kOrigin).share; }

TEST(Lights, DirectionalShinesAgainstItsDirection) {
  const kernel::LightRecord light = light_at(0, 0, 0);
  const kernel::Incident in = kernel::light_directional(&light, kOrigin);
  EXPECT_EQ(in.l.z, 1.0f);
  EXPECT_EQ(in.share, 1.0f);
}

TEST(Lights, PointFallsWithTheSquareOfTheDistance) {
  const kernel::LightRecord light = light_at(0, 3, 4);
  const kernel::Incident in = kernel::light_point(&light, kOrigin);
  EXPECT_FLOAT_EQ(in.l.y, 0.6f);
  EXPECT_FLOAT_EQ(in.l.z, 0.8f);
  EXPECT_FLOAT_EQ(in.share, 1.0f / 25);
}

TEST(Lights, FalloffsOfTheRigFile) {
  kernel::LightRecord light = light_at(0, 0, 4);
  light.range = 8;
  const auto falloff = [&](int kind) {
    light.falloff = kind;
    light.falloff_scale = kind == kernel::FALLOFF_linear ? 1.0f / (8 - 2) : 1.0f / (8 * 8);
    return kernel::light_point(&light, kOrigin).share;
  };
  EXPECT_FLOAT_EQ(falloff(kernel::FALLOFF_inverse_square), 1 / 16.0f);
  EXPECT_FLOAT_EQ(falloff(kernel::FALLOFF_windowed), (1 - 1 / 16.0f) / 16);
  EXPECT_FLOAT_EQ(falloff(kernel::FALLOFF_linear), 2 / 3.0f);
  EXPECT_FLOAT_EQ(falloff(kernel::FALLOFF_none), 1);
  light.position[2] = 9;
  EXPECT_EQ(falloff(kernel::FALLOFF_windowed), 0);
  EXPECT_EQ(falloff(kernel::FALLOFF_linear), 0);
  light.position[2] = 1;
  EXPECT_EQ(falloff(kernel::FALLOFF_linear), 1);
}

/// A spot of 20 to 30 degrees, seen this many degrees off its axis, 1 away.
double spot_at(int cone, double degrees, double inner = 20, double outer = 30) {
  const double angle = degrees * kPi / 180;
  kernel::LightRecord light = light_at(static_cast<float>(std::sin(angle)), 0, static_cast<float>(std::cos(angle)));
  const auto edge = [&](double d) { return static_cast<float>(cone == kernel::CONE_linear ? d * kPi / 180 : std::cos(d * kPi / 180)); };
  light.inner = edge(inner);
  light.outer = edge(outer);
  light.cone = cone;
  return share(light);
}

TEST(Lights, ConesOfTheRigFile) {
  const double t = (std::cos(26 * kPi / 180) - std::cos(30 * kPi / 180)) / (std::cos(20 * kPi / 180) - std::cos(30 * kPi / 180));
  EXPECT_NEAR(spot_at(kernel::CONE_gltf, 26), t * t, 1e-5);
  EXPECT_NEAR(spot_at(kernel::CONE_smoothstep, 26), t * t * (3 - 2 * t), 1e-5);
  EXPECT_NEAR(spot_at(kernel::CONE_linear, 26), 0.4, 1e-5);
  for (const int cone : {kernel::CONE_gltf, kernel::CONE_smoothstep, kernel::CONE_linear}) {
    EXPECT_NEAR(spot_at(cone, 19), 1, 1e-6);
    EXPECT_EQ(spot_at(cone, 31), 0);
    EXPECT_EQ(spot_at(cone, 120), 0);
    EXPECT_NEAR(spot_at(cone, 29.9, 30, 30), 1, 1e-6);  // a hard edge
    EXPECT_EQ(spot_at(cone, 30.1, 30, 30), 0);
  }
}

kernel::Surface bumped(double degrees) {
  kernel::Surface s = kernel::default_surface();
  s.n = kernel::real3_of(static_cast<float>(std::sin(degrees * kPi / 180)), 0.0f, static_cast<float>(std::cos(degrees * kPi / 180)));
  return s;
}

kernel::real3 towards(double degrees) {
  return kernel::real3_of(static_cast<float>(std::sin(degrees * kPi / 180)), 0.0f, static_cast<float>(std::cos(degrees * kPi / 180)));
}

TEST(Bump, NothingComesFromBelowTheUnperturbedSurface) {
  for (const int rule : {kernel::BUMP_horizon, kernel::BUMP_smith}) {
    EXPECT_EQ(kernel::bump_visibility(rule, bumped(30), towards(100)), 0.0f);
    EXPECT_EQ(kernel::bump_visibility(rule, bumped(0), kernel::real3_of(1.0f, 0.0f, 0.0f)), 0.0f);
  }
  EXPECT_EQ(kernel::bump_visibility(kernel::BUMP_horizon, bumped(30), towards(80)), 1.0f);
}

// Estevez, Lecocq and Stein 2019: alpha^2 = tan^2(bump)/8, G1 of GGX.
TEST(Bump, SmithHidesGrazingLight) {
  const double alpha2 = std::pow(std::tan(40 * kPi / 180), 2) / 8;
  const double wanted = 2 / (1 + std::sqrt(1 + alpha2 * std::pow(std::tan(75 * kPi / 180), 2)));
  EXPECT_NEAR(kernel::bump_visibility(kernel::BUMP_smith, bumped(40), towards(75)), wanted, 1e-6);
  EXPECT_FLOAT_EQ(kernel::bump_visibility(kernel::BUMP_smith, bumped(0), towards(75)), 1.0f);
}

}  // namespace
}  // namespace relume
