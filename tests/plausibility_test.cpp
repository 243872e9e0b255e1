// The laboratory's integrals against tables made in double precision, and its laws on functions that keep and break them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>

#include "host/ggx_albedo.h"
#include "lab/direction_pairs.h"
#include "lab/furnace.h"
#include "lab/plausibility.h"
#include "lab/term_laws.h"

namespace relume {
namespace {

std::vector<std::string> parts_of(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);) parts.push_back(part);
  return parts;
}

/// A table's model: our BRDF, settings, and what its parameters are called here.
struct Model {
  std::string brdf;
  std::vector<std::string> set;
  std::map<std::string, std::string> names;
};

// beckmann_smith_exact_nofresnel is Smith with the error function, and ours the rational fit to it; phong_original's table has f n.l as ours.
const std::map<std::string, Model> kModels{
    {"lambert", {"lambert", {}, {{"rho", "albedo"}}}},
    {"oren_nayar_qualitative", {"oren_nayar", {"albedo=1"}, {{"sigma_rad", "sigma"}}}},
    {"eon", {"eon", {}, {{"rho", "albedo"}, {"roughness", "sigma_r"}}}},
    {"disney_diffuse", {"burley", {"albedo=1"}, {}}},
    {"phong_original", {"phong_original", {"ks=1"}, {}}},
    {"phong_plausible", {"phong", {"ks=1"}, {}}},
    {"blinn_phong_ndf", {"blinn_phong", {"ks=1"}, {}}},
    {"blinn_phong_exact", {"blinn_phong_exact", {"ks=1"}, {}}},
    {"cook_torrance_beckmann_vgroove_nofresnel", {"cook_torrance", {"fresnel=none", "ks=1", "shadowing=v_groove"}, {}}},
    {"beckmann_smith_rational_nofresnel", {"beckmann", {"fresnel=none", "ks=1", "shadowing=smith_separable"}, {}}},
    {"beckmann_rational_conductor", {"beckmann", {"fresnel=conductor", "shadowing=smith_separable"}, {}}},
    {"ggx_smith_separable_nofresnel", {"ggx", {"fresnel=none", "ks=1", "shadowing=smith_separable"}, {}}},
    {"ggx_smith_correlated_nofresnel", {"ggx", {"fresnel=none", "ks=1", "shadowing=smith"}, {}}},
    {"ggx_correlated_schlick", {"ggx", {"fresnel=schlick", "shadowing=smith"}, {}}},
    {"ggx_separable_conductor", {"ggx", {"fresnel=conductor", "shadowing=smith_separable"}, {}}},
    {"principled_base_specular", {"principled", {"ior=1.5"}, {{"base", "albedo"}, {"specular", "specular_level"}}}},
};

/// "alpha=0.1;eta=0.2" of a table, in our words.
Setting settings_of(const Model& model, const std::string& parameters) {
  Setting set = model.set;
  for (const std::string& assignment : parts_of(parameters, ';')) {
    const std::vector<std::string> sides = parts_of(assignment, '=');
    set.push_back((model.names.contains(sides[0]) ? model.names.at(sides[0]) : sides[0]) + "=" + sides[1]);
  }
  return set;
}

TEST(DirectionalAlbedo, AgreesWithTablesInDoublePrecision) {
  std::ifstream in(RELUME_CORPUS "/oracle/albedo.csv");  // all, where the corpus is; else every other row of it
  if (!in) in.open(RELUME_SOURCE "/tests/data/oracle/albedo.csv");
  std::string line;
  std::getline(in, line);
  int rows = 0;
  double worst = 0;
  while (std::getline(in, line)) {
    const std::vector<std::string> cells = parts_of(line, ',');
    if (!kModels.contains(cells[0])) continue;
    const Model& model = kModels.at(cells[0]);
    const Brdf brdf(model.brdf, settings_of(model, cells[1]), lab_device("twin"));
    const double off = std::abs(directional_albedo(brdf, std::stod(cells[2])).value.x - std::stod(cells[3]));
    EXPECT_LE(off, 1e-5) << line;
    worst = std::max(worst, off);
    ++rows;
  }
  std::printf("directional albedos: %d rows, at most %.1g off\n", rows, worst);
  EXPECT_GT(rows, 200);
}

// The host's albedo of GGX is another formula, in double precision, and another integral, over visible normals (to 1e-5).
TEST(DirectionalAlbedo, AgreesWithAnotherIntegralWhereNoTableIs) {
  for (const double alpha : {0.02, 0.15, 0.8})
    for (const double n_v : {0.97, 0.4, 0.1}) {
      const Brdf brdf("ggx", {"fresnel=none", "ks=1", "alpha=" + std::to_string(alpha)}, lab_device("twin"));
      EXPECT_NEAR(directional_albedo(brdf, n_v).value.x, ggx_albedo(alpha, n_v), 1.5e-5) << alpha << " " << n_v;
    }
}

TEST(DirectionalAlbedo, SharpLobesAndGrazingViewsConverge) {
  // Straight on, all of Ks is reflected; at grazing angles half of the lobe is below the horizon, and what is above is weighted by n.l.
  for (const char* exponent : {"0", "3", "700", "10000"})
    for (const char* name : {"phong", "blinn_phong_exact"}) {
      const Brdf brdf(name, {"ks=1", std::string("exponent=") + exponent}, lab_device("twin"));
      EXPECT_NEAR(directional_albedo(brdf, 1).value.x, 1, 2e-6) << name << " " << exponent;
    }
  // A mirror-like surface seen from its side still reflects what it meets, but for the shadow of its facets.
  const Brdf ggx("ggx", {"fresnel=none", "ks=1", "alpha=0.0001"}, lab_device("twin"));
  EXPECT_NEAR(directional_albedo(ggx, 0.02).value.x, 1, 1e-4);
  const Brdf pair("lambert+ggx", {"albedo=0.5", "f0=0", "f90=0"}, lab_device("twin"));
  EXPECT_NEAR(directional_albedo(pair, 0.5).value.y, 0.5, 1e-6);
}

/// The grid thinned to a few settings, which is quick.
Examined few_settings(const Lobe& lobe, std::size_t count = 3) {
  Examined e = examined(lobe, {}, lab_device("twin"));
  std::vector<Setting> some;
  for (std::size_t i = 0; i < e.grid.size(); i += std::max<std::size_t>(1, e.grid.size() / count)) some.push_back(e.grid[i]);
  e.grid = some;
  return e;
}

/// The same lobe with what it reflects changed.
Examined changed(const Examined& e, const std::function<glm::dvec3(const glm::dvec3&, const DirectionPair&)>& change) {
  Examined other = e;
  other.with = [=](const Setting& set) -> ReflectanceOf {
    return [=, whole = e.with(set)](std::span<const DirectionPair> pairs) {
      std::vector<Reflectance> values = whole(pairs);
      for (std::size_t i = 0; i < values.size(); ++i) values[i] = {change(values[i].total(), pairs[i]), {}};
      return values;
    };
  };
  return other;
}

std::vector<std::string> failures_of(Examined e) {
  std::vector<std::string> laws;
  for (const LawFinding& f : findings_of(e))
    if (f.fails()) laws.push_back(f.law);
  return laws;
}

class EveryLobe : public testing::TestWithParam<const Lobe*> {};

TEST_P(EveryLobe, KeepsItsClaimsAndNoneOfThemIsIdle) {
  Examined e = few_settings(*GetParam(), 6);
  const std::vector<LawFinding> findings = findings_of(e);
  EXPECT_EQ(std::size_t(std::count_if(findings.begin(), findings.end(), [](const LawFinding& f) { return f.claimed; })), GetParam()->claims.size());
  for (const LawFinding& f : findings) {
    EXPECT_FALSE(f.fails()) << f.law << " by " << f.deviation.by << " at " << f.deviation.where;
  }
}

TEST_P(EveryLobe, OnePercentMoreOrLessIsCaught) {
  if (GetParam()->name == "merl") GTEST_SKIP() << "a measured table is what was measured: no law pins it";
  const Examined e = few_settings(*GetParam());
  for (const double factor : {1.01, 0.99})
    EXPECT_FALSE(failures_of(changed(e, [=](const glm::dvec3& f, const DirectionPair&) { return factor * f; })).empty()) << factor;
}

TEST_P(EveryLobe, AnErrorThatDependsOnTheLightIsCaught) {
  const Examined e = few_settings(*GetParam());
  EXPECT_FALSE(failures_of(changed(e, [](const glm::dvec3& f, const DirectionPair& p) { return (1 + 0.2 * p.l.z) * f; })).empty());
}

std::vector<const Lobe*> all_lobes() {
  std::vector<const Lobe*> all;
  for (const auto* lobes : {&diffuse_lobes(), &specular_lobes()})
    for (const Lobe& lobe : *lobes) all.push_back(&lobe);
  return all;
}
INSTANTIATE_TEST_SUITE_P(Lobes, EveryLobe, testing::ValuesIn(all_lobes()), [](const auto& info) {
  return std::string(info.param->diffuse ? "diffuse_" : "specular_") + std::string(info.param->name);
});

/// A lobe that is no kernel's, one channel, without parameters.
Examined made_up(const std::vector<std::string>& claims, const std::function<double(const DirectionPair&)>& f_r) {
  Examined e;
  e.name = "made_up";
  e.claims = claims;
  e.grid = {{}};
  e.with = [=](const Setting&) -> ReflectanceOf {
    return [=](std::span<const DirectionPair> pairs) {
      std::vector<Reflectance> values;
      for (const DirectionPair& p : pairs) values.push_back({glm::dvec3(f_r(p) * p.l.z), {}});
      return values;
    };
  };
  return e;
}

double half_vector_cosine(const DirectionPair& p) {
  const glm::dvec3 sum = p.l + p.v;
  return sum.z / std::sqrt(sum.x * sum.x + sum.y * sum.y + sum.z * sum.z);
}

TEST(Laws, ALobeOfOurOwnThatKeepsThemPasses) {
  const auto lambert = [](const DirectionPair&) { return 1 / std::numbers::pi; };
  EXPECT_EQ(failures_of(made_up({"positive", "reciprocal", "conserving", "white", "lambertian", "normal", "normalised"}, lambert)),
            std::vector<std::string>());
  const auto blinn = [](const DirectionPair& p) { return 22 / (2 * std::numbers::pi) * std::pow(half_vector_cosine(p), 20); };
  EXPECT_EQ(failures_of(made_up({"positive", "reciprocal", "normals"}, blinn)), std::vector<std::string>());
}

TEST(Laws, EachFallsOnAFunctionThatBreaksIt) {
  constexpr double pi = std::numbers::pi;
  const auto breaks = [](const std::string& law, const std::function<double(const DirectionPair&)>& f_r) {
    EXPECT_EQ(failures_of(made_up({law}, f_r)), std::vector<std::string>{law});
  };
  breaks("positive", [](const DirectionPair& p) { return p.l.z - 0.01; });
  breaks("positive", [](const DirectionPair& p) { return p.l.z < 0.5 ? NAN : 1.0; });
  breaks("reciprocal", [](const DirectionPair& p) { return 22 / (2 * pi) * std::pow(p.l.z, 20); });  // n.l where n.h should be
  breaks("conserving", [](const DirectionPair&) { return 1.01 / pi; });
  breaks("normalised", [](const DirectionPair&) { return 0.99 / pi; });
  breaks("white", [](const DirectionPair& p) { return (1 - 0.01 * p.v.x) / pi; });
  breaks("lambertian", [](const DirectionPair& p) { return (1 + 1e-4 * p.l.x * p.v.x) / pi; });
  breaks("normal", [](const DirectionPair& p) { return p.v.z * 1.0001 / pi; });
  breaks("peak", [](const DirectionPair& p) { return 0.99 / p.l.z; });
  breaks("normals", [](const DirectionPair& p) { return 22.22 / (2 * pi) * std::pow(half_vector_cosine(p), 20); });
}

/// The kernels' factors, changed.
TermsWith factors(const std::string& distribution, const std::function<void(TermValues&, const DirectionPair&)>& change) {
  return [=](const Setting& set) -> TermsOf {
    return [=, whole = terms_of(distribution, set, lab_device("twin"))](std::span<const DirectionPair> pairs) {
      std::vector<TermValues> values = whole(pairs);
      for (std::size_t i = 0; i < values.size(); ++i) change(values[i], pairs[i]);
      return values;
    };
  };
}

TEST(Terms, KeepTheirLaws) {
  for (const LawFinding& f : findings_of_terms(lab_device("twin")))
    EXPECT_FALSE(f.fails()) << f.subject << " " << f.law << " " << f.deviation.by << " " << f.deviation.where;
  EXPECT_LE(distribution_normalised(factors("ggx", [](TermValues&, const DirectionPair&) {})).by, 1e-6);
}

TEST(Terms, ErrorsInThemAreCaught) {
  for (const char* name : {"ggx", "beckmann"}) {
    const auto one_percent = [](TermValues& t, const DirectionPair&) {
      t.d *= 1.01;
      t.g *= 1.01;
      t.f *= 1.01;
    };
    EXPECT_GT(distribution_normalised(factors(name, one_percent)).by, 9e-3) << name;
    EXPECT_GT(shadowing_bounded(factors(name, one_percent), true).by, 9e-3) << name;
    EXPECT_GT(weak_furnace(factors(name, one_percent)).by, 9e-3) << name;
    const auto normal_for_half = [](TermValues& t, const DirectionPair& p) { t.d *= p.v.z; };
    EXPECT_GT(distribution_of_facets(factors(name, normal_for_half)).by, 0.1) << name;
    EXPECT_GT(fresnel_bounded("dielectric", factors(name, one_percent)).by, 9e-3);
    const auto falls = [](TermValues& t, const DirectionPair& p) { t.f *= p.v.z > 0.4 && p.v.z < 0.5 ? 0.5 : 1.0; };
    EXPECT_GT(fresnel_bounded("schlick", factors(name, falls)).by, 1e-3);
  }
}

TEST(Terms, AreTheSameOnEveryDevice) {
  const std::vector<DirectionPair> pairs = direction_pairs();
  for (const DeviceInfo& info : list_devices())
    for (const char* distribution : {"ggx", "beckmann"})
      for (const char* shadowing : {"smith", "v_groove"}) {
        const Setting set{"alpha=0.2", std::string("shadowing=") + shadowing, "fresnel=dielectric"};
        const std::vector<TermValues> here = terms_of(distribution, set, lab_device(std::to_string(info.index)))(pairs);
        const std::vector<TermValues> twin = terms_of(distribution, set, lab_device("twin"))(pairs);
        const double allowed = info.correctly_rounded ? 0 : 1e-4;
        for (std::size_t i = 0; i < pairs.size(); ++i) {
          EXPECT_LE(std::abs(here[i].d - twin[i].d), allowed * twin[i].d) << info.name;
          EXPECT_LE(std::abs(here[i].g - twin[i].g), allowed) << info.name;
          EXPECT_LE(std::abs(here[i].f.x - twin[i].f.x), allowed) << info.name;
        }
      }
}

}  // namespace
}  // namespace relume
