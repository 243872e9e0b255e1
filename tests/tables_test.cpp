// The tables that the host makes for lobes, against the oracle, closed forms and conservation of energy.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

#include "host/conversions.h"
#include "host/ggx_albedo.h"
#include "host/rough_transmittance.h"
#include "host/visible_normals.h"
#include "kernels/cycles_tables.h"

namespace relume {
namespace {

TEST(Quadrature, IsExactForPolynomials) {
  for (const int order : {1, 2, 7, 32, 128}) {
    const Quadrature rule = gauss_legendre(order);
    for (const int power : {0, 1, 2 * order - 1}) {
      double sum = 0;
      for (int i = 0; i < order; ++i) sum += rule.weights[i] * std::pow(rule.nodes[i], power);
      EXPECT_NEAR(sum, 1.0 / (power + 1), 1e-14) << order << " points, power " << power;
    }
    for (int i = 1; i < order; ++i) EXPECT_LT(rule.nodes[i - 1], rule.nodes[i]);
  }
}

TEST(VisibleNormals, HalfOfTheRoughestSurfaceReflectsBelowTheHorizon) {
  const Quadrature rule = gauss_legendre(32);
  EXPECT_NEAR(mean_over_visible_normals(1, 1, rule, rule, [](double, double) { return 1.0; }), 0.5, 1e-6);
  EXPECT_NEAR(mean_over_visible_normals(1e-3, 0.6, rule, rule, [](double v_m, double n_l) { return v_m * n_l; }), 0.36, 1e-4);  // nearly a mirror
}

/// Rows of the oracle's albedo.csv of one model: alpha, n.v, albedo.
struct OracleAlbedo {
  double alpha, n_v, albedo;
};
std::vector<OracleAlbedo> oracle_albedos(const std::string& model) {
  std::ifstream in(std::string(RELUME_SOURCE) + "/tests/data/oracle/albedo.csv");
  std::vector<OracleAlbedo> rows;
  for (std::string line; std::getline(in, line);) {
    std::istringstream text(line);
    std::string name, parameters, n_v, albedo;
    std::getline(text, name, ','), std::getline(text, parameters, ','), std::getline(text, n_v, ','), std::getline(text, albedo, ',');
    if (name == model)
      rows.push_back({std::atof(parameters.substr(parameters.find('=') + 1).c_str()), std::atof(n_v.c_str()), std::atof(albedo.c_str())});
  }
  return rows;
}

TEST(GgxAlbedo, AgreesWithTheOracle) {
  const auto rows = oracle_albedos("ggx_smith_correlated_nofresnel");
  ASSERT_GE(rows.size(), 5u);
  for (const OracleAlbedo& row : rows) EXPECT_NEAR(ggx_albedo(row.alpha, row.n_v), row.albedo, 1e-5) << row.alpha << " " << row.n_v;
}

TEST(GgxAlbedo, SeparableShadowingAgreesWithTheOracleToo) {
  const Quadrature slices = gauss_legendre(16), along = gauss_legendre(24);
  const auto rows = oracle_albedos("ggx_smith_separable_nofresnel");
  ASSERT_GE(rows.size(), 5u);
  for (const OracleAlbedo& row : rows) {
    const auto g1 = [&](double, double c) { return c > 0 ? 2 / (1 + std::sqrt(1 + row.alpha * row.alpha * (1 / (c * c) - 1))) : 0; };
    EXPECT_NEAR(mean_over_visible_normals(row.alpha, row.n_v, slices, along, g1), row.albedo, 1e-5) << row.alpha << " " << row.n_v;
  }
}

TEST(CyclesTables, FallWithRoughnessFromAMirror) {
  const std::vector<float> t = cycles_tables();
  constexpr int side = RELUME_CYCLES_TABLE_SIDE;
  ASSERT_EQ(t.size(), std::size_t(RELUME_CYCLES_TABLES_LENGTH));
  for (int m = 0; m < side; ++m) EXPECT_EQ(t[RELUME_CYCLES_E_START + m * side], 1);
  for (int r = 1; r < side; ++r) {
    EXPECT_LT(t[RELUME_CYCLES_E_START + (side - 1) * side + r], t[RELUME_CYCLES_E_START + (side - 1) * side + r - 1]);
    EXPECT_LT(t[RELUME_CYCLES_E_MEAN_START + r], t[RELUME_CYCLES_E_MEAN_START + r - 1]);
  }
  EXPECT_NEAR(t[RELUME_CYCLES_E_START + side * side - 1], 1 - std::log(2.0), 1e-6);  // alpha 1 seen straight
}

TEST(CyclesTables, MeanIsTheMeanOfTheRow) {
  const std::vector<float> t = cycles_tables();
  constexpr int side = RELUME_CYCLES_TABLE_SIDE;
  for (int r = 0; r < side; ++r) {
    double sum = 0;  // trapezoids of 2 mu E
    for (int m = 1; m < side; ++m) sum += 2.0 * m / (side - 1) * t[RELUME_CYCLES_E_START + m * side + r] / (side - 1) * (m == side - 1 ? 0.5 : 1);
    EXPECT_NEAR(t[RELUME_CYCLES_E_MEAN_START + r], sum, 1e-3) << r;
  }
}

double dielectric_fresnel(double cos_i, double eta) {
  const double sin2_t = (1 - cos_i * cos_i) / (eta * eta);
  if (sin2_t >= 1) return 1;
  const double cos_t = std::sqrt(1 - sin2_t);
  const double s = (cos_i - eta * cos_t) / (cos_i + eta * cos_t), p = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
  return 0.5 * (s * s + p * p);
}

/// Of diffuse light that a smooth surface throws back.
double diffuse_fresnel(double eta) {
  double sum = 0;
  for (int i = 0; i < 200000; ++i) sum += dielectric_fresnel(std::sqrt((i + 0.5) / 200000), eta) / 200000;
  return sum;
}

TEST(RoughTransmittance, OfANearlySmoothSurfaceIsFresnels) {
  for (const bool beckmann : {false, true}) {
    const RoughTransmittance rough = rough_transmittance(beckmann, 1e-3, 1.5);
    for (int i = 8; i < rough_transmittance_entries; ++i) {
      EXPECT_NEAR(rough.external[i], 1 - dielectric_fresnel(i / 63.0, 1.5), 1e-3) << beckmann << " " << i;
    }
    // Mitsuba's mean over 64 cosines from 0 to 1 gives the last one, 2 F(1), half an interval too much.
    EXPECT_NEAR(rough.internal_fdr, (63 * diffuse_fresnel(1 / 1.5) + 0.04) / 64, 1e-3) << beckmann;
  }
}

TEST(RoughTransmittance, WithoutContrastNothingIsReflected) {
  for (const bool beckmann : {false, true}) {
    const RoughTransmittance rough = rough_transmittance(beckmann, 0.01, 1);
    EXPECT_NEAR(rough.internal_fdr, 0, 1e-15) << beckmann;
    EXPECT_NEAR(rough.external[63], 1, 1e-4) << beckmann;
  }
}

TEST(RoughTransmittance, IsAShareThatRoughnessLowersSeenStraight) {
  for (const bool beckmann : {false, true}) {
    RoughTransmittance smoother = rough_transmittance(beckmann, 0.05, 1.5);
    for (const double alpha : {0.2, 0.5, 1.0}) {
      const RoughTransmittance rough = rough_transmittance(beckmann, alpha, 1.5);
      for (const float t : rough.external) EXPECT_TRUE(t > 0 && t < 1) << beckmann << " " << alpha << " " << t;
      EXPECT_LT(rough.external[63], smoother.external[63] + 1e-6) << beckmann << " " << alpha;
      EXPECT_LT(rough.internal_fdr, smoother.internal_fdr) << beckmann << " " << alpha;
      smoother = rough;
    }
  }
}

TEST(RoughTransmittance, TheSmoothFitIsNearTheIntegral) {
  for (const double ior : {1.2, 1.5, 1.8}) EXPECT_NEAR(smooth_internal_fdr(ior), diffuse_fresnel(1 / ior), 6e-3 * diffuse_fresnel(1 / ior)) << ior;
}

TEST(Ior, OfASpecularLevel) {
  EXPECT_NEAR(ior_from_specular_level(0.5), 1.5, 1e-15);
  EXPECT_EQ(ior_from_specular_level(0), 1);
  for (const double level : {0.1, 0.5, 1.0}) EXPECT_NEAR(dielectric_fresnel(1, ior_from_specular_level(level)), 0.08 * level, 1e-15);
}

}  // namespace
}  // namespace relume
