// The laws that the lists claim of each lobe, measured: positive, reciprocal, conserving. A law that a lobe does not claim must be seen broken.
#include <gtest/gtest.h>

#include <cstdio>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "host/ggx_albedo.h"
#include "host/merl_numbers.h"
#include "host/rough_transmittance.h"
#include "tests/reflectance.h"

namespace relume {
namespace {

constexpr double kPi = 3.14159265358979323846;

struct ParameterRange {
  std::string_view name;
  int components;
  double preset, lowest, highest;
};
#define RELUME_RANGE_ROW(name, components, preset, lowest, highest, ...) {#name, components, preset, lowest, highest},
constexpr ParameterRange kRanges[] = {RELUME_PARAMETERS(RELUME_RANGE_ROW)};

std::vector<std::string> words_in(std::string_view text) {
  std::istringstream in{std::string(text)};
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

/// The words of a list's entry, or one empty word where it offers no choice.
std::vector<std::string> choices_in(std::string_view text) {
  std::vector<std::string> words = words_in(text);
  if (words.empty()) words.emplace_back();
  return words;
}

bool claims(const kernel::Lobe& lobe, const std::string& law) { return lobe.claims.find(law) != std::string_view::npos; }

/// A surface to measure a lobe on, with how it differs from the defaults.
struct Sample {
  kernel::Surface surface;
  std::string text;
};

/// Where what the table buffer holds starts.
constexpr int kRoughPlastic = RELUME_CYCLES_TABLES_LENGTH, kMeasured = kRoughPlastic + rough_transmittance_entries;

/// What the table buffer holds when a program is run: Cycles' tables, a rough plastic's, and a measured BRDF.
const std::vector<float>& tables() {
  static const std::vector<float> all = [] {
    std::vector<float> t = cycles_tables();
    const RoughTransmittance rough = rough_transmittance(false, 0.3, 1.5);
    t.insert(t.end(), rough.external.begin(), rough.external.end());
    // A measured BRDF, bright enough to reflect more than arrives, as nothing keeps a file from doing.
    std::vector<float> measured = merl_numbers(stand_in_table(45, 15, 12));
    for (std::size_t i = RELUME_MERL_HEADER; i < measured.size(); ++i) measured[i] *= 8;
    t.insert(t.end(), measured.begin(), measured.end());
    return t;
  }();
  return all;
}

/// Reflectances (three components from 0 to 1) at 1, so that a lobe reflects all that it can.
kernel::Surface brightest_surface() {
  kernel::Surface s = kernel::default_surface();
  s.tables = tables().data();
  s.table = kMeasured;
  for (const ParameterRange& range : kRanges)
    if (range.components == 3 && range.lowest == 0 && range.highest == 1) kernel::set_parameter(s, range.name, 1);
  return s;
}

/// The ranges of the lobe's numbers.
std::vector<ParameterRange> numbers_of(const kernel::Lobe& lobe) {
  std::vector<ParameterRange> numbers;
  for (const std::string& name : words_in(lobe.parameters))
    for (const ParameterRange& range : kRanges)
      if (range.name == name && range.name != "table" && range.components == 1) numbers.push_back(range);
  return numbers;
}

/// The lobe's numbers one at a time at their ends, between, and below: a file may hold anything.
std::vector<Sample> with_each_number(const kernel::Lobe& lobe, const Sample& base) {
  std::vector<Sample> samples = {base};
  const auto add = [&](std::string_view name, double value) {
    Sample sample = base;
    kernel::set_parameter(sample.surface, name, value);
    std::ostringstream text;
    text << base.text << name << "=" << value << " ";
    sample.text = text.str();
    samples.push_back(sample);
  };
  for (const ParameterRange& range : numbers_of(lobe))
    for (const double share : {0.0, 1e-4, 0.02, 0.1, 0.25, 0.5, 1.0}) add(range.name, range.lowest + share * (range.highest - range.lowest));
  if (lobe.parameters.find("alpha") != std::string_view::npos) add("alpha", 0);
  if (lobe.name == "plastic") {
    Sample rough = base;
    rough.surface.transmittance = kRoughPlastic;
    rough.surface.fdr = 0.6f;
    rough.text += "rough ";
    samples.push_back(rough);
  }
  return samples;
}

/// Every choice of terms that the lobe offers, with each of its numbers, the others at their defaults and at their highest; `fresnels` are the ones
/// to try where it has any.
std::vector<Sample> samples_of(const kernel::Lobe& lobe, std::string_view fresnels) {
  std::vector<Sample> samples;
  for (const std::string& fresnel : choices_in(lobe.fresnels.empty() ? "" : fresnels))
    for (const std::string& shadowing : choices_in(lobe.shadowings))
      for (const std::string& distribution : choices_in(lobe.distributions)) {
        Sample base{brightest_surface(), ""};
        if (lobe.kind == "diffuse") kernel::set_parameter(base.surface, "f0", kernel::default_surface().f0.x);  // what is mirrored cannot be diffused
        if (!fresnel.empty()) base.surface.fresnel = kernel::fresnel_named(fresnel);
        if (!shadowing.empty()) base.surface.shadowing = kernel::shadowing_named(shadowing);
        if (!distribution.empty()) base.surface.distribution = kernel::distribution_named(distribution);
        for (const std::string& word : {fresnel, shadowing, distribution})
          if (!word.empty()) base.text += word + " ";
        Sample highest = base;
        highest.text += "highest ";
        for (const ParameterRange& range : numbers_of(lobe)) kernel::set_parameter(highest.surface, range.name, range.highest);
        for (const Sample& start : {base, highest})
          for (const Sample& sample : with_each_number(lobe, start)) samples.push_back(sample);
      }
  return samples;
}

constexpr std::string_view kEveryFresnel = "schlick dielectric conductor none";

Direction at_height(double z, double phi) {
  const double r = std::sqrt(std::max(0.0, 1 - z * z));
  return {r * std::cos(phi), r * std::sin(phi), z};
}

/// Pairs of directions above the surface: anywhere, grazing, mirrored, and the ends.
std::vector<std::pair<Direction, Direction>> direction_pairs() {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<std::pair<Direction, Direction>> pairs;
  for (int i = 0; i < 300; ++i) {
    const double grazing = i % 3 == 0 ? std::pow(10.0, -8 * unit(random)) : unit(random);
    const Direction v = at_height(1e-8 + 0.99999999 * unit(random), 2 * kPi * unit(random));
    pairs.emplace_back(at_height(grazing, 2 * kPi * unit(random)), v);
    pairs.emplace_back(Direction{-v.x, -v.y, v.z}, v);
  }
  for (const double z : {1.0, 1e-4, 1e-8})
    for (const double w : {1.0, 1e-4, 1e-8})
      for (const double phi : {0.0, 1.5, kPi}) pairs.emplace_back(at_height(z, phi), at_height(w, 0));
  return pairs;
}

class Law : public testing::TestWithParam<kernel::Lobe> {};

TEST_P(Law, PositiveAndFinite) {
  const kernel::Lobe lobe = GetParam();
  ASSERT_TRUE(claims(lobe, "positive")) << "no lobe may be negative";
  for (const Sample& sample : samples_of(lobe, kEveryFresnel))
    for (const auto& [l, v] : direction_pairs()) {
      const double value = reflectance(lobe, sample.surface, l, v);
      ASSERT_TRUE(value >= 0 && std::isfinite(value)) << sample.text << "n.l " << l.z << " n.v " << v.z << " l.v " << dot(l, v) << ": " << value;
    }
}

TEST_P(Law, Reciprocal) {
  const kernel::Lobe lobe = GetParam();
  double worst = 0;
  std::string where;
  for (const Sample& sample : samples_of(lobe, kEveryFresnel))
    for (const auto& [l, v] : direction_pairs()) {
      const double there = reflectance(lobe, sample.surface, l, v) / l.z;
      const double back = reflectance(lobe, sample.surface, v, l) / v.z;
      // Below 1e-30 what is left of a float's digits is few.
      const double difference = std::abs(there - back) / (std::max(there, back) + 1e-30);
      if (difference > worst) {
        worst = difference;
        std::ostringstream text;
        text << sample.text << "n.l " << l.z << " n.v " << v.z << " l.v " << dot(l, v);
        where = text.str();
      }
    }
  const std::string name = std::string(lobe.kind) + " " + std::string(lobe.name);
  if (claims(lobe, "reciprocal")) {
    EXPECT_LE(worst, 3e-6) << where;
  } else {
    std::printf("exception: %s is not reciprocal: up to %.0f %% apart (%s)\n", name.c_str(), 100 * worst, where.c_str());
    EXPECT_GT(worst, 1e-3) << name << " keeps the law: let the list say so";
  }
}

TEST_P(Law, Conserving) {
  const kernel::Lobe lobe = GetParam();
  double most = 0;
  std::string where;
  for (const Sample& sample : samples_of(lobe, "none"))
    for (const double n_v : {1.0, 0.7, 0.3, 0.1, 0.02}) {
      const double albedo = directional_albedo(lobe, sample.surface, n_v, half_vector_width(lobe, sample.surface), 160);
      if (albedo > most) {
        most = albedo;
        std::ostringstream text;
        text << sample.text << "n.v " << n_v;
        where = text.str();
      }
    }
  const std::string name = std::string(lobe.kind) + " " + std::string(lobe.name);
  if (claims(lobe, "conserving")) {
    EXPECT_LE(most, 1 + 1e-3) << where;
    EXPECT_GT(most, 0.5) << "a lobe that reflects so little was not measured";
  } else {
    std::printf("exception: %s is not conserving: reflects up to %.4g of what arrives (%s)\n", name.c_str(), most, where.c_str());
    EXPECT_GT(most, 1 + 1e-3) << name << " keeps the law: let the list say so";
  }
}

INSTANTIATE_TEST_SUITE_P(Lobes, Law, testing::ValuesIn(kernel::lobes), [](const testing::TestParamInfo<kernel::Lobe>& info) {
  return std::string(info.param.kind) + "_" + std::string(info.param.name);
});

/// Cosines of a normal of the microsurface at this angle: l = v = h.
kernel::Cosines facing(double cosine) { return kernel::cosines_from(cosine, cosine, 1); }

/// Integral of D n.h over the hemisphere, tan = width sqrt(u/(1-u)).
template <typename Distribution>
double projected_area(double width, const Distribution& d) {
  constexpr int steps = 4000;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double u = (i + 0.5) / steps;
    const double tan2 = width * width * u / (1 - u);
    const double cosine = 1 / std::sqrt(1 + tan2);
    const double pdf = width * width / (kPi * std::pow(cosine, 3) * std::pow(width * width + tan2, 2));
    sum += d(facing(cosine)) * cosine / pdf / steps;
  }
  return sum;
}

TEST(Distribution, NormalsProjectToTheSurface) {
  for (const float alpha : {0.0001f, 0.01f, 0.05f, 0.3f, 1.0f}) {
    EXPECT_NEAR(projected_area(alpha, [&](const kernel::Cosines& c) { return kernel::ggx_distribution(c, alpha); }), 1, 1e-5) << "ggx " << alpha;
    EXPECT_NEAR(projected_area(alpha, [&](const kernel::Cosines& c) { return kernel::beckmann_distribution(c, alpha); }), 1, 1e-5)
        << "beckmann " << alpha;
  }
  kernel::Surface s = brightest_surface();
  for (const float exponent : {1.0f, 20.0f, 1000.0f, 10000.0f}) {
    s.exponent = exponent;
    const auto d = [&](const kernel::Cosines& c) { return kernel::specular_blinn_phong(c, s).x / c.n_l; };
    EXPECT_NEAR(projected_area(std::sqrt(2 / (exponent + 2)), d), 1, 1e-5) << "blinn_phong " << exponent;
  }
}

// Straight on, D G F/4 is 1/(4 pi alpha^2).
TEST(Distribution, AMirrorIsALobeOfTheLeastWidth) {
  kernel::Surface s = brightest_surface();
  s.fresnel = kernel::FRESNEL_none;
  for (const float alpha : {0.0f, 1e-5f, 1e-4f, 2e-4f}) {
    s.alpha = alpha;
    const double peak = 1 / (4 * kPi * std::pow(std::max(double(alpha), 1e-4), 2));
    for (const auto& lobe : {kernel::specular_ggx, kernel::specular_beckmann, kernel::specular_cook_torrance})
      EXPECT_NEAR(lobe(facing(1), s).x, peak, 1e-6 * peak) << alpha;
  }
}

TEST(Fresnel, ReflectsBetweenNothingAndAllAndAllAtGrazing) {
  kernel::Surface s = kernel::default_surface();
  for (s.fresnel = 0; s.fresnel < kernel::FRESNEL_none; ++s.fresnel)
    for (float ior = 1.0f; ior <= 4.0f; ior += 0.25f) {
      s.ior = ior;
      s.eta = kernel::grey(ior);
      s.k = kernel::grey(4 - ior + 0.01f);
      for (int i = 0; i <= 100; ++i) {
        const double f = kernel::fresnel_of(s, static_cast<float>(i) / 100).x;
        EXPECT_TRUE(f >= 0 && f <= 1) << s.fresnel << " " << ior << " " << i;
      }
      const bool nothing_there = ior == 1 && s.fresnel == kernel::FRESNEL_dielectric;
      EXPECT_NEAR(kernel::fresnel_of(s, 1e-6f).x, nothing_there ? 0 : 1, 1e-4) << s.fresnel << " " << ior;
    }
}

TEST(Fresnel, SchlickMixesBaseColourByMetallic) {
  kernel::Surface s = kernel::default_surface();
  s.albedo = kernel::real3_of(0.9f, 0.6f, 0.3f);
  s.f90 = kernel::real3_of(1.0f, 0.5f, 0.25f);
  s.metallic = 0.5f;
  const kernel::real3 normal = kernel::fresnel_schlick(s, 1.0f);
  EXPECT_FLOAT_EQ(normal.x, 0.47f);
  EXPECT_FLOAT_EQ(normal.y, 0.32f);
  EXPECT_FLOAT_EQ(normal.z, 0.17f);
  const kernel::real3 grazing = kernel::fresnel_schlick(s, 0.0f);
  EXPECT_FLOAT_EQ(grazing.y, 0.5f);
  EXPECT_FLOAT_EQ(kernel::fresnel_schlick(s, 0.5f).x, 0.47f + 0.53f / 32);
}

}  // namespace
}  // namespace relume
