// Base colour, metallic and specular level from GlossCol and DiffCol: back from what CyclesAlbedo writes, and from what Blender wrote.
#include "host/cycles_f0.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "host/cycles_albedo.h"
#include "tests/rendered_rows.h"

namespace relume {
namespace {

/// To 11 bits, as a half float holds a number from 1e-4 to 1.
double as_half(double x) {
  int exponent;
  const double mantissa = std::frexp(x, &exponent);
  return std::ldexp(std::nearbyint(std::ldexp(mantissa, 11)), exponent - 11);
}

struct Passes {
  Rgb glossy, diffuse;
};

/// The two passes of a surface, as a half float file holds them.
Passes passes_of(const CyclesSurface& s, double roughness, double n_v, bool multi_ggx) {
  const CyclesAlbedo albedo(roughness, n_v, multi_ggx);
  const double dielectric = albedo.dielectric(0.08 * s.specular_level);
  Passes passes;
  for (int c = 0; c < 3; ++c) {
    passes.glossy[c] = as_half(s.metallic * albedo.metal(s.base_color[c]) + (1 - s.metallic) * dielectric);
    passes.diffuse[c] = as_half(s.base_color[c] * (1 - s.metallic) * (1 - dielectric));
  }
  return passes;
}

/// Surfaces of this metallic seen at several angles; `check` gets what was written and what was found.
template <typename Check>
void round_trips(double metallic, double level, const Check& check) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 300; ++i) {
    const CyclesSurface wrote{{0.2 + 0.7 * unit(random), 0.1 + 0.3 * unit(random), 0.5 + 0.4 * unit(random)}, metallic, level};
    const double roughness = 0.1 + 0.9 * unit(random), n_v = 0.1 + 0.9 * unit(random);
    for (const bool multi_ggx : {true, false}) {
      const Passes p = passes_of(wrote, roughness, n_v, multi_ggx);
      SCOPED_TRACE(testing::Message() << "roughness " << roughness << " n.v " << n_v << " metallic " << metallic << " level " << level << " "
                                      << multi_ggx);
      check(wrote, solve_cycles_surface(p.glossy, p.diffuse, roughness, n_v, multi_ggx));
    }
  }
}

TEST(CyclesSurface, DielectricsGiveTheirSpecularLevel) {
  for (const double level : {0.2, 0.5, 1.0})
    round_trips(0, level, [](const CyclesSurface& wrote, const CyclesSurface& found) {
      EXPECT_EQ(found.metallic, 0);
      EXPECT_NEAR(found.specular_level, wrote.specular_level, 5e-3);
    });
}

TEST(CyclesSurface, MetalsGiveTheirBaseColour) {
  round_trips(1, 0.5, [](const CyclesSurface& wrote, const CyclesSurface& found) {
    EXPECT_EQ(found.metallic, 1);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(found.base_color[c], wrote.base_color[c], 4e-3);
  });
}

TEST(CyclesSurface, PartOfBothIsTakenApart) {
  for (const double metallic : {0.2, 0.5, 0.8})
    for (const double level : {0.3, 0.5, 0.8})
      round_trips(metallic, level, [](const CyclesSurface& wrote, const CyclesSurface& found) {
        EXPECT_NEAR(found.metallic, wrote.metallic, 2e-2);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(found.base_color[c], wrote.base_color[c], 2e-2);
      });
}

TEST(CyclesSurface, WhateverIsFoundWritesTheSamePasses) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 2000; ++i) {
    const double grey = unit(random), tint = 0.2 * unit(random) * (i % 2);
    const CyclesSurface wrote{{grey, grey * (1 - tint), grey * (1 - 2 * tint)}, std::min(1.0, 1.2 * unit(random)), unit(random)};
    const double roughness = 0.05 + 0.95 * unit(random), n_v = 0.05 + 0.95 * unit(random);
    const Passes given = passes_of(wrote, roughness, n_v, true);
    const CyclesSurface found = solve_cycles_surface(given.glossy, given.diffuse, roughness, n_v, true);
    const Passes again = passes_of(found, roughness, n_v, true);
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(again.glossy[c], given.glossy[c], 5e-3 * given.glossy[c]) << i << " metallic " << wrote.metallic << " grey " << grey;
  }
}

TEST(CyclesSurface, BlackIsADielectricAndNothingReflectsNothing) {
  const Passes black = passes_of({{0, 0, 0}, 0, 0.5}, 0.4, 0.7, true);
  const CyclesSurface found = solve_cycles_surface(black.glossy, black.diffuse, 0.4, 0.7, true);
  EXPECT_EQ(found.metallic, 0);
  EXPECT_NEAR(found.specular_level, 0.5, 5e-3);
  EXPECT_EQ(solve_cycles_surface({0, 0, 0}, {0.5, 0.5, 0.5}, 0.4, 0.7, true).specular_level, 0);
}

TEST(CyclesSurface, HostilePixelsGiveFiniteSurfaces) {
  const double nan = std::nan(""), infinity = INFINITY;
  for (const double g : {nan, infinity, -1.0, 0.0, 1e-8, 0.04, 5.0})
    for (const double d : {nan, infinity, -1.0, 0.0, 0.5, 5.0})
      for (const double roughness : {nan, -1.0, 0.0, 2.0})
        for (const double n_v : {nan, -1.0, 0.0, 1.0}) {
          const CyclesSurface s = solve_cycles_surface({g, 0.5 * g, g}, {d, d, 0.2 * d}, roughness, n_v, true);
          for (const double x : {s.base_color[0], s.base_color[1], s.base_color[2], s.metallic})
            EXPECT_TRUE(x >= 0 && x <= 1) << g << " " << d << " " << roughness;
          EXPECT_TRUE(s.specular_level >= 0 && s.specular_level <= 2) << g << " " << d << " " << roughness << " " << n_v;
        }
}

TEST(CyclesSurface, FoundInBlendersOwnPasses) {
  int principled = 0;
  for (const RenderedRow& row : rendered_rows("cycles.csv")) {
    if (row.text("specular") != "cycles_principled") continue;
    const auto wrote = row.settings();
    const kernel::Surface s = row.surface();
    const CyclesSurface found =
        solve_cycles_surface(row.colour("glossy_albedo"), wrote.at("albedo"), s.roughness, s.n_v, row.text("distribution") == "multi_ggx");
    SCOPED_TRACE(row.text("case") + " " + row.text("settings"));
    EXPECT_NEAR(found.metallic, wrote.at("metallic")[0], 5e-3);
    const bool metal = wrote.at("metallic")[0] > 0, dielectric = wrote.at("metallic")[0] < 1;
    for (int c = 0; metal && c < 3; ++c) EXPECT_NEAR(found.base_color[c], wrote.at("base_color")[c], 5e-3);
    if (dielectric) {
      EXPECT_NEAR(found.specular_level, wrote.at("specular_level")[0], 1e-2);
    }
    ++principled;
  }
  EXPECT_EQ(principled, 64);
}

}  // namespace
}  // namespace relume
