// The kernels' elementary functions against the C library's in double, over dense sweeps of floats; and what is written where numbers are not finite.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <limits>

#include "tests/kernel_lanes.h"

namespace relume {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// How far `got` is from `wanted`, in units of the last place that a float of wanted's size has.
double ulps(float got, double wanted) {
  int exponent = 0;
  std::frexp(wanted, &exponent);
  return std::abs(static_cast<double>(got) - wanted) / std::ldexp(1.0, std::max(exponent, -125) - 24);
}

using Measured = std::function<float(float)>;
using Exact = std::function<double(double)>;

/// The largest error over every `stride`-th float from `low` to `high`, both of one sign and |low| < |high|.
double largest_error(const char* what, float low, float high, uint32_t stride, const Measured& measured, const Exact& exact) {
  double worst = 0;
  float at = low;
  const uint32_t last = std::bit_cast<uint32_t>(high);
  for (uint64_t bits = std::bit_cast<uint32_t>(low); bits <= last; bits += stride) {
    const float x = std::bit_cast<float>(static_cast<uint32_t>(bits));
    const double error = ulps(measured(x), exact(x));
    if (!(error <= worst)) {
      worst = error;
      at = x;
    }
  }
  std::printf("%-34s %.3f ulp at %.9g\n", what, worst, static_cast<double>(at));
  return worst;
}

double e_to(double x) { return std::exp(x); }
double log_of_one_plus(double x) { return std::log1p(x); }
double angle_of(double x) { return std::acos(x); }

TEST(Math, ExponentialHoldsItsBound) {
  EXPECT_LE(largest_error("exp, 1e-30..88.72", 1e-30f, 88.7228f, 331, kernel::exp_of, e_to), 1.2);
  EXPECT_LE(largest_error("exp, -1e-30..-62.38", -1e-30f, -62.38f, 331, kernel::exp_of, e_to), 1.2);
}

TEST(Math, ExponentialAtItsEnds) {
  EXPECT_EQ(kernel::exp_of(0.0f), 1.0f);
  EXPECT_EQ(kernel::exp_of(-0.0f), 1.0f);
  EXPECT_EQ(kernel::exp_of(-kInfinity), 0.0f);
  EXPECT_EQ(kernel::exp_of(-1e30f), 0.0f);
  EXPECT_EQ(kernel::exp_of(-62.39f), 0.0f);
  EXPECT_GT(kernel::exp_of(-62.38f), 8e-28f);
  EXPECT_LE(kernel::exp_of(88.72283f), std::numeric_limits<float>::max());
  EXPECT_EQ(kernel::exp_of(88.73f), kInfinity);
  EXPECT_EQ(kernel::exp_of(kInfinity), kInfinity);
  EXPECT_TRUE(std::isnan(kernel::exp_of(kNan)));
}

TEST(Math, LogarithmOfOnePlusHoldsItsBound) {
  EXPECT_LE(largest_error("log1p, 1e-30..3.4e38", 1e-30f, std::numeric_limits<float>::max(), 331, kernel::log1p_of, log_of_one_plus), 1.8);
  EXPECT_LE(largest_error("log1p, -1e-30..-1+2^-24", -1e-30f, std::nextafter(-1.0f, 0.0f), 331, kernel::log1p_of, log_of_one_plus), 1.8);
}

TEST(Math, LogarithmOfOnePlusAtItsEnds) {
  EXPECT_EQ(kernel::log1p_of(0.0f), 0.0f);
  EXPECT_TRUE(std::isnan(kernel::log1p_of(kNan)));
}

TEST(Math, ArcCosineHoldsItsBound) {
  EXPECT_LE(largest_error("acos, 1e-30..1", 1e-30f, 1.0f, 331, kernel::arc_cosine, angle_of), 2.7);
  EXPECT_LE(largest_error("acos, 0.99..1", 0.99f, 1.0f, 1, kernel::arc_cosine, angle_of), 2.7);
  EXPECT_LE(largest_error("acos, -1e-30..-1", -1e-30f, -1.0f, 331, kernel::arc_cosine, angle_of), 2.7);
}

TEST(Math, ArcCosineTakesTheNearerEnd) {
  EXPECT_EQ(kernel::arc_cosine(1.0f), 0.0f);
  EXPECT_EQ(kernel::arc_cosine(1.5f), 0.0f);
  EXPECT_FLOAT_EQ(kernel::arc_cosine(-1.0f), 3.14159265f);
  EXPECT_FLOAT_EQ(kernel::arc_cosine(-kInfinity), 3.14159265f);
}

TEST(Math, SineOfATurnHoldsItsBound) {
  for (int k = -10000; k <= 20000; ++k) {
    const float t = float(k) * 1e-4f;
    ASSERT_NEAR(kernel::sine_of_turn(t), std::sin(2 * M_PI * double(t)), 2e-7) << t;
    if (t < 0 || t > 1) continue;
    ASSERT_NEAR(kernel::cosine_of_turn(t), std::cos(2 * M_PI * double(t)), 6e-7) << t;  // t + 1/4 is rounded
  }
}

TEST(Math, AngleOfAPoint) {
  for (const double radius : {1e-3, 1.0, 1e3})
    for (int k = 0; k < 10000; ++k) {
      const double angle = 2 * M_PI * (k + 0.5) / 10000;
      ASSERT_NEAR(kernel::angle_of(float(radius * std::cos(angle)), float(radius * std::sin(angle))), angle, 1.5e-6) << angle;
    }
  EXPECT_TRUE(std::isfinite(kernel::angle_of(0.0f, 0.0f)));
}

TEST(Finite, NothingButTheLargestNumbersIsChanged) {
  constexpr float large = 0.999f * std::numeric_limits<float>::max();
  for (const float x : {0.0f, 1e-38f, -5.0f, large, -large}) EXPECT_EQ(kernel::finite(x), x);
  EXPECT_GE(kernel::finite(kInfinity), large);
  EXPECT_LE(kernel::finite(kInfinity), std::numeric_limits<float>::max());
  EXPECT_EQ(kernel::finite(-kInfinity), -kernel::finite(kInfinity));
  EXPECT_EQ(kernel::finite(kNan), 0.0f);
}

}  // namespace
}  // namespace relume
