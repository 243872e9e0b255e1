// The C++ view of the kernels' lists: complete, consistent with itself, and with errors that list what is allowed.
#include "host/lobes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "lab/plausibility.h"
#include "tests/refusal.h"

namespace relume {
namespace {

bool contains(const std::vector<std::string_view>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<Lobe> all_lobes() {
  std::vector<Lobe> lobes = diffuse_lobes();
  lobes.insert(lobes.end(), specular_lobes().begin(), specular_lobes().end());
  return lobes;
}

TEST(Lobes, NumbersFollowTheKernelsEnumerations) {
  for (const bool diffuse : {true, false}) {
    const std::vector<Lobe>& lobes = diffuse ? diffuse_lobes() : specular_lobes();
    for (std::size_t i = 0; i < lobes.size(); ++i) {
      EXPECT_EQ(lobes[i].number, static_cast<int>(i) + 1) << lobes[i].name;  // 0 is "none"
      EXPECT_EQ(lobes[i].diffuse, diffuse);
    }
  }
  for (std::size_t i = 0; i < parameters().size(); ++i) EXPECT_EQ(parameters()[i].field, static_cast<int>(i)) << parameters()[i].name;
  for (const auto* terms : {&fresnels(), &shadowings(), &distributions(), &light_types()})
    for (std::size_t i = 0; i < terms->size(); ++i) EXPECT_EQ((*terms)[i].number, static_cast<int>(i)) << (*terms)[i].name;
}

TEST(Lobes, EveryNameInAListIsDefinedSomewhere) {
  for (const Lobe& lobe : all_lobes()) {
    for (const auto name : lobe.parameters) EXPECT_NE(find_parameter(name), nullptr) << lobe.name << ": " << name;
    for (const auto name : lobe.fresnels) EXPECT_NE(find_term(fresnels(), name), nullptr) << lobe.name << ": " << name;
    for (const auto name : lobe.shadowings) EXPECT_NE(find_term(shadowings(), name), nullptr) << lobe.name << ": " << name;
    for (const auto name : lobe.distributions) EXPECT_NE(find_term(distributions(), name), nullptr) << lobe.name << ": " << name;
    for (const auto claim : lobe.claims) {
      const std::string law = parsed_claim(std::string(claim)).law;
      EXPECT_NE(std::find(law_names().begin(), law_names().end(), law), law_names().end()) << lobe.name << ": " << claim;
    }
    EXPECT_FALSE(lobe.source.empty()) << lobe.name;
  }
  for (const Term& fresnel : fresnels())
    for (const auto name : fresnel.parameters) EXPECT_NE(find_parameter(name), nullptr) << fresnel.name << ": " << name;
}

TEST(Lobes, EveryLobeHasItsFile) {
  const std::filesystem::path kernels = std::filesystem::path(RELUME_SOURCE) / "kernels";
  for (const Lobe& lobe : all_lobes())
    EXPECT_TRUE(std::filesystem::exists(kernels / (lobe.diffuse ? "diffuse" : "specular") / (std::string(lobe.name) + ".h"))) << lobe.name;
  for (const Term& light : light_types()) EXPECT_TRUE(std::filesystem::exists(kernels / "lights" / (std::string(light.name) + ".h"))) << light.name;
  for (const Term& term : fresnels()) EXPECT_TRUE(std::filesystem::exists(kernels / "fresnel" / (std::string(term.name) + ".h"))) << term.name;
}

TEST(Lobes, DefaultsLieInTheirRanges) {
  for (const Parameter& parameter : parameters()) {
    EXPECT_LE(parameter.lowest, parameter.fallback) << parameter.name;
    EXPECT_LE(parameter.fallback, parameter.highest) << parameter.name;
    EXPECT_TRUE(parameter.components == 1 || parameter.components == 3) << parameter.name;
    EXPECT_FALSE(parameter.meaning.empty()) << parameter.name;
  }
}

TEST(Lobes, ParametersSayWhoGivesThem) {
  EXPECT_TRUE(parameter_named("transmittance").from_host);
  EXPECT_TRUE(parameter_named("table").is_file);
  EXPECT_FALSE(parameter_named("albedo").is_file);
  EXPECT_TRUE(parameter_named("fdr").from_host);
  EXPECT_FALSE(parameter_named("albedo").from_host);
  EXPECT_TRUE(parameter_named("nonlinear").is_switch);
  EXPECT_FALSE(parameter_named("metallic").is_switch);
  EXPECT_FALSE(contains(parameter_names(), "transmittance"));
  EXPECT_TRUE(contains(parameter_names(), "exponent"));
}

TEST(Lobes, UsersMayWriteRoughnessForAlphaAndAlbedoForBaseColour) {
  const Lobe microfacet{"m", false, {"alpha", "transmittance"}, {}, {}, {}, {}, "", 1};
  EXPECT_EQ(user_parameters(microfacet), (std::vector<std::string_view>{"alpha", "roughness"}));
  const Lobe cycles{"c", false, {"roughness", "base_color", "albedo"}, {}, {}, {}, {}, "", 1};
  EXPECT_EQ(user_parameters(cycles), (std::vector<std::string_view>{"roughness", "base_color", "albedo"}));
  const Lobe plain{"p", false, {"roughness"}, {}, {}, {}, {}, "", 1};
  EXPECT_EQ(user_parameters(plain), (std::vector<std::string_view>{"roughness"}));
  const std::vector<std::string_view> schlick = user_parameters(term_named(fresnels(), "schlick", "fresnel term"));
  EXPECT_TRUE(contains(schlick, "albedo"));  // a metal's f0
  EXPECT_TRUE(contains(schlick, "f0"));
}

TEST(Lobes, FixedNamesAreThere) {
  for (const char* name : {"lambert", "lambert_original", "oren_nayar", "eon", "burley", "plastic", "principled", "gltf", "cycles"})
    EXPECT_NE(find_lobe(true, name), nullptr) << name;
  for (const char* name : {"phong_original", "phong", "blinn_phong_original", "blinn_phong", "blinn_phong_exact", "cook_torrance", "beckmann", "ggx",
                           "principled", "cycles_principled", "cycles_glossy", "merl"})
    EXPECT_NE(find_lobe(false, name), nullptr) << name;
  for (const char* name : {"schlick", "dielectric", "conductor", "none"}) EXPECT_NE(find_term(fresnels(), name), nullptr) << name;
  for (const char* name : {"v_groove", "smith", "smith_separable"}) EXPECT_NE(find_term(shadowings(), name), nullptr) << name;
  for (const char* name : {"multi_ggx", "ggx", "beckmann"}) EXPECT_NE(find_term(distributions(), name), nullptr) << name;
  for (const char* name : {"directional", "point", "spot"}) EXPECT_NE(find_term(light_types(), name), nullptr) << name;
}

TEST(Lobes, ErrorsListWhatIsAllowed) {
  EXPECT_EQ(error_of([] { term_named(distributions(), "ggxx", "distribution"); }), "no distribution \"ggxx\" (has: multi_ggx, ggx, beckmann)");
  EXPECT_EQ(error_of([] { term_named(light_types(), "bulb", "light type"); }), "no light type \"bulb\" (has: directional, point, spot)");
  EXPECT_EQ(error_of([] { lobe_named(true, "lamber"); }).find("no diffuse lobe \"lamber\" (has: none, lambert"), 0u);
  EXPECT_EQ(error_of([] { lobe_named(false, "lambert"); }).find("no specular lobe \"lambert\" (has: none, "), 0u);
  EXPECT_EQ(error_of([] { parameter_named("rough"); }).find("no parameter \"rough\" (has: albedo, kd, ks, "), 0u);
  EXPECT_EQ(error_of([] { parameter_named("rough"); }).find("transmittance"), std::string::npos);
}

}  // namespace
}  // namespace relume
