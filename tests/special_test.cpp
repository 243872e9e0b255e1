// The lobes of Mitsuba and Cycles against pixels that those renderers rendered, and against laws of their own.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "host/conversions.h"
#include "host/ggx_albedo.h"
#include "host/rough_transmittance.h"
#include "tests/reflectance.h"
#include "tests/rendered_rows.h"

namespace relume {
namespace {

double largest(const Rgb& c) { return std::max({c[0], c[1], c[2]}); }

/// Cycles' tables, with room for a plastic's behind them.
const std::vector<float>& cycles() {
  static const std::vector<float> tables = cycles_tables();
  return tables;
}

/// Binds a Mitsuba row as the host does: a rough plastic's tables, and the ior of a specular level.
Rgb mitsuba_radiance(const RenderedRow& row) {
  kernel::Surface s = row.surface();
  const auto settings = row.settings();
  std::vector<float> tables = cycles();
  s.shadowing = kernel::SHADOWING_smith_separable;
  s.fresnel = kernel::FRESNEL_dielectric;
  if (settings.count("specular_level")) s.ior = float(ior_from_specular_level(settings.at("specular_level")[0]));
  if (row.text("diffuse") == "plastic" && settings.count("alpha")) {
    const RoughTransmittance rough = rough_transmittance(row.text("specular") == "beckmann", settings.at("alpha")[0], settings.at("ior")[0]);
    s.transmittance = float(tables.size());
    s.fdr = rough.internal_fdr;
    tables.insert(tables.end(), rough.external.begin(), rough.external.end());
  }
  s.tables = tables.data();
  Rgb sum = row.radiance(lobe_named("diffuse", row.text("diffuse")), s);
  if (row.text("specular") == "none") return sum;
  const Rgb specular = row.radiance(lobe_named("specular", row.text("specular")), s);
  for (int c = 0; c < 3; ++c) sum[c] += specular[c];
  return sum;
}

TEST(Mitsuba, PixelsOfPrincipledAndPlastic) {
  const auto rows = rendered_rows("mitsuba.csv");
  ASSERT_EQ(rows.size(), 210u);
  double worst = 0;
  for (const RenderedRow& row : rows) {
    const Rgb ours = mitsuba_radiance(row), wanted = row.colour("wanted");
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(ours[c], wanted[c], 1e-5 * wanted[c]) << row.text("case") << " " << row.text("settings");  // both are single precision
      worst = std::max(worst, std::abs(ours[c] - wanted[c]) / wanted[c]);
    }
  }
  std::printf("within %.1e\n", worst);
}

TEST(Cycles, PixelsOfDiffuseGlossyAndPrincipled) {
  const auto rows = rendered_rows("cycles.csv");
  ASSERT_EQ(rows.size(), 128u);
  double worst = 0;
  for (const RenderedRow& row : rows) {
    kernel::Surface s = row.surface();
    s.tables = cycles().data();
    s.distribution = kernel::distribution_named(row.text("distribution"));
    for (const char* half : {"diffuse", "specular"}) {
      if (row.text(half) == "none") continue;
      const Rgb ours = row.radiance(lobe_named(half, row.text(half)), s), wanted = row.colour(half);
      for (int c = 0; c < 3; ++c) {
        // Most files are half floats, and the picture is the mean of 32 places in the pixel.
        EXPECT_NEAR(ours[c], wanted[c], 1e-2 * largest(wanted)) << half << " of " << row.text("case") << " " << row.text("settings");
        if (largest(wanted) > 0) worst = std::max(worst, std::abs(ours[c] - wanted[c]) / largest(wanted));
      }
    }
  }
  std::printf("within %.1e\n", worst);
}

/// White, with Cycles' tables.
kernel::Surface white(double roughness, int distribution) {
  kernel::Surface s = kernel::default_surface();
  kernel::set_parameter(s, "roughness", roughness);
  s.tables = cycles().data();
  s.distribution = distribution;
  s.albedo = s.base_color = s.glossy_albedo = kernel::grey(1.0f);
  s.metallic = 1;
  return s;
}

TEST(Cycles, WhiteMultiGgxReflectsAllThatArrives) {
  for (const char* name : {"cycles_glossy", "cycles_principled"})
    for (const double roughness : {0.2, 0.45, 0.8, 1.0})
      for (const double n_v : {0.1, 0.4, 1.0}) {
        const kernel::Lobe lobe = lobe_named("specular", name);
        const kernel::Surface multi = white(roughness, kernel::DISTRIBUTION_multi_ggx), single = white(roughness, kernel::DISTRIBUTION_ggx);
        EXPECT_NEAR(directional_albedo(lobe, multi, n_v, roughness * roughness, 200), 1, 2e-3) << name << " " << roughness << " " << n_v;
        EXPECT_NEAR(directional_albedo(lobe, single, n_v, roughness * roughness, 200), ggx_albedo(roughness * roughness, n_v), 1e-3)
            << name << " " << roughness;
      }
}

TEST(Cycles, WhiteRoughDiffuseReflectsAllThatArrives) {
  kernel::Surface s = white(0.5, 0);
  for (const float roughness : {0.0f, 0.3f, 1.0f})
    for (const double n_v : {0.1, 0.5, 1.0}) {
      s.diffuse_roughness = roughness;
      EXPECT_NEAR(directional_albedo(lobe_named("diffuse", "cycles"), s, n_v, 0, 200), 1, 1e-3) << roughness << " " << n_v;
    }
}

// Cycles' own limit is roughness^4 = 2e-10, a roughness of 0.00376.
TEST(Cycles, AMirrorShowsNoPointLight) {
  const kernel::Cosines mirror = kernel::cosines_from(0.8, 0.8, 0.28);
  for (const char* name : {"cycles_glossy", "cycles_principled"}) {
    EXPECT_EQ(kernel::reflect_lobe(lobe_named("specular", name), mirror, white(0.003758, kernel::DISTRIBUTION_multi_ggx)).x, 0) << name;
    EXPECT_GT(kernel::reflect_lobe(lobe_named("specular", name), mirror, white(0.003765, kernel::DISTRIBUTION_multi_ggx)).x, 1e6) << name;
  }
}

TEST(Cycles, SpecularLevelScalesReflectanceAtNormalIncidence) {
  kernel::Surface s = white(0.5, kernel::DISTRIBUTION_ggx);
  s.metallic = 0;
  const kernel::Cosines straight = kernel::cosines_from(1, 1, 1);
  const double lobe = kernel::cycles_lobe(straight, s);
  for (const float level : {0.0f, 0.25f, 0.5f, 1.0f}) {
    s.specular_level = level;
    EXPECT_NEAR(kernel::specular_cycles_principled(straight, s).x / lobe, 0.08 * level, 1e-6) << level;
  }
}

// Kulla and Conty 2017: their fit to a dielectric's mean reflectance, and Schlick's mean, which is f0 + (1 - f0)/21.
TEST(Cycles, LaterBouncesReflectTheMeanOfFresnel) {
  kernel::Surface s = white(0.5, kernel::DISTRIBUTION_multi_ggx);
  s.one_bounce = 0.6f;
  s.one_bounce_mean = 0.7f;
  const auto gain_of = [](double fresnel) { return 1 + fresnel * 0.7 / (1 - fresnel * 0.3) * (1 - 0.6) / 0.6; };
  for (const float eta : {1.5f, 2.0f, 3.0f}) {
    const float f0 = (eta - 1) * (eta - 1) / ((eta + 1) * (eta + 1));
    const kernel::CyclesGain gain = kernel::cycles_gain(s, kernel::grey(0.3f), f0, eta);
    EXPECT_NEAR(gain.dielectric, gain_of(std::max<double>((eta - 1) / (4.08567 + 1.00071 * eta), f0)), 1e-6) << eta;
    EXPECT_NEAR(gain.metal.y, gain_of(0.3 + 0.7 / 21), 1e-6);
  }
}

TEST(Principled, ClearcoatByTheFormulaOfThePaper) {
  kernel::Surface s = kernel::default_surface();
  s.albedo = kernel::grey(0.0f);
  s.metallic = s.clearcoat = 1;
  for (const float gloss : {0.0f, 0.5f, 1.0f})
    for (const double tilt : {0.0, 0.001, 0.05}) {
      s.clearcoat_gloss = gloss;
      const double alpha = 0.1 + (0.001 - 0.1) * double(gloss), angle = 0.5;  // l and v at this angle from h, h tilted in their plane
      const double n_l = std::cos(angle + tilt), n_v = std::cos(angle - tilt), n_h = std::cos(tilt), l_h = std::cos(angle);
      const auto g1 = [](double c) { return 2 / (1 + std::sqrt(1 + 0.0625 * (1 / (c * c) - 1))); };
      const double d = (alpha * alpha - 1) / (M_PI * std::log(alpha * alpha) * (1 + (alpha * alpha - 1) * n_h * n_h));
      const double wanted = 0.25 * d * (0.04 + 0.96 * std::pow(1 - l_h, 5)) * g1(n_l) * g1(n_v) * n_l;
      const kernel::Cosines c = kernel::cosines_from(n_l, n_v, std::cos(2 * angle));
      EXPECT_NEAR(kernel::principled_clearcoat(c, s, kernel::v_h(c)), wanted, 2e-6 * wanted) << gloss << " " << tilt;
    }
}

TEST(Principled, TintIsTheBaseColourAtLuminanceOne) {
  kernel::Surface s = kernel::default_surface();
  s.albedo = kernel::real3_of(0.4f, 0.2f, 0.1f);
  const kernel::real3 tint = kernel::base_tint(s);
  EXPECT_NEAR(0.212671 * tint.x + 0.715160 * tint.y + 0.072169 * tint.z, 1, 1e-6);
  EXPECT_FLOAT_EQ(tint.x / tint.z, 4);
  s.albedo = kernel::grey(0.0f);
  EXPECT_EQ(kernel::base_tint(s).y, 1);
}

TEST(Plastic, SmoothInternalReflectanceIsTheHosts) {
  kernel::Surface s = kernel::default_surface();
  for (const float ior : {1.1f, 1.5f, 2.0f}) {
    s.ior = ior;
    EXPECT_NEAR(kernel::plastic_internal_reflectance(s), smooth_internal_fdr(double(ior)), 2e-7) << ior;
  }
}

}  // namespace
}  // namespace relume
