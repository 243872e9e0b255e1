// Material files and --set: good files as they are meant, and every refusal with its whole text.
#include "host/materials.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "tests/refusal.h"

namespace relume {
namespace {

using Numbers = std::vector<double>;

/// Reads the text as standard input.
MaterialFile read_string(const std::string& text) {
  const StandardInput input(text);
  return read_materials("-");
}

Material material_of(const std::string& members) { return *read_string("{\"relume\": 1, \"materials\": {\"default\": {" + members + "}}}").fallback; }

std::string file_error(const std::string& text) {
  return error_of([&] { read_string(text); });
}

/// Of a material in the default entry, without the place that all of these errors share.
std::string material_error(const std::string& members) {
  const std::string place = "standard input:1: materials[\"default\"]: ";
  const std::string error = error_of([&] { material_of(members); });
  return error.starts_with(place) ? error.substr(place.size()) : "elsewhere: " + error;
}

std::string set_error(const std::string& assignment) {
  Material material;
  return error_of([&] { set_parameter(material, assignment); });
}

TEST(Materials, ReadsTheContractsExample) {
  const MaterialFile file = read_string(R"({"relume": 1, "ids": "shape_index",
     "materials": {"0": {"diffuse": "lambert", "specular": "none", "albedo": "layer:albedo"},
                   "4294967295": {"diffuse": "none", "specular": "cook_torrance", "alpha": 0.2, "f0": [0.9,0.6,0.3]},
                   "default": {"specular": "ggx", "roughness": 0.5, "twosided": true}}})");
  EXPECT_EQ(file.ids, "shape_index");
  ASSERT_EQ(file.by_id.size(), 2u);
  const Material& first = file.by_id.at(0);
  EXPECT_EQ(first.diffuse, "lambert");
  EXPECT_EQ(first.specular, "none");
  EXPECT_EQ(std::get<LayerValue>(first.parameters.at("albedo")).layer, "albedo");
  EXPECT_FALSE(first.twosided);
  const Material& second = file.by_id.at(4294967295u);
  EXPECT_EQ(std::get<Numbers>(second.parameters.at("alpha")), Numbers{0.2});
  EXPECT_EQ(std::get<Numbers>(second.parameters.at("f0")), (Numbers{0.9, 0.6, 0.3}));
  ASSERT_TRUE(file.fallback);
  EXPECT_EQ(file.fallback->diffuse, "");
  EXPECT_EQ(file.fallback->twosided, true);
}

TEST(Materials, AGreyStandsForThreeAndASwitchMayBeABoolean) {
  const Material material = material_of(R"("diffuse": "plastic", "specular": "auto", "albedo": 0.5, "nonlinear": true, "ior": 1.6)");
  EXPECT_EQ(std::get<Numbers>(material.parameters.at("albedo")), (Numbers{0.5, 0.5, 0.5}));
  EXPECT_EQ(std::get<Numbers>(material.parameters.at("nonlinear")), Numbers{1});
  EXPECT_EQ(material.specular, "");
}

TEST(Materials, TexturesAreFoundBesideTheFile) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / ("relume_materials_" + std::to_string(::getpid()));
  std::filesystem::create_directory(folder);
  std::ofstream(folder / "m.json") << R"({"relume": 1, "materials": {
      "1": {"diffuse": "lambert", "albedo": {"texture": "maps/a.exr", "uv": "st", "filter": "nearest", "v": "down"}},
      "2": {"diffuse": "lambert", "albedo": {"texture": "/b.exr"}}}})";
  const MaterialFile file = read_materials(folder / "m.json");
  std::filesystem::remove_all(folder);
  const TextureValue given = std::get<TextureValue>(file.by_id.at(1).parameters.at("albedo"));
  EXPECT_EQ(given.file, folder / "maps/a.exr");
  EXPECT_EQ(given.uv, "st");
  EXPECT_FALSE(given.bilinear);
  EXPECT_TRUE(given.v_down);
  const TextureValue defaults = std::get<TextureValue>(file.by_id.at(2).parameters.at("albedo"));
  EXPECT_EQ(defaults.file, "/b.exr");
  EXPECT_EQ(defaults.uv, "uv");
  EXPECT_TRUE(defaults.bilinear);
  EXPECT_FALSE(defaults.v_down);
}

TEST(Materials, TheParametersTellTheFresnelTerm) {
  const Lobe& ggx = lobe_named(false, "ggx");
  const auto fresnel = [&](const std::string& members) {
    return fresnel_of(material_of("\"diffuse\": \"none\", \"specular\": \"ggx\", " + members), ggx)->name;
  };
  EXPECT_EQ(fresnel(R"("alpha": 0.2)"), "schlick");
  EXPECT_EQ(fresnel(R"("f0": 0.04, "metallic": 1, "albedo": [1, 0.8, 0.3])"), "schlick");
  EXPECT_EQ(fresnel(R"("ior": 1.5)"), "dielectric");
  EXPECT_EQ(fresnel(R"("k": 3)"), "conductor");
  EXPECT_EQ(fresnel(R"("eta": [0.2, 0.9, 1.1], "k": [3.9, 2.5, 2.1])"), "conductor");
  EXPECT_EQ(fresnel(R"("fresnel": "none", "ks": 1)"), "none");
  EXPECT_EQ(fresnel_of({}, lobe_named(false, "phong")), nullptr);
}

TEST(Materials, RefusesWhatTheLobesDoNotHave) {
  EXPECT_EQ(material_error(R"("diffuse": "lambert", "specular": "none", "roughness": 0.5)"),
            "\"roughness\": not a parameter of diffuse lambert and specular none (has: albedo)");
  EXPECT_EQ(material_error(R"("diffuse": "none", "specular": "ggx", "ior": 1.5, "f0": 0.04)"),
            "\"f0\": not a parameter of diffuse none and specular ggx with fresnel dielectric (has: alpha, roughness, ior)");
  EXPECT_EQ(material_error(R"("diffuse": "none", "specular": "none", "albedo": 1)"),
            "\"albedo\": not a parameter of diffuse none and specular none (they take none)");
  EXPECT_EQ(material_error(R"("diffuse": "none", "specular": "phong", "shadowing": "smith")"),
            "\"shadowing\": \"smith\" is not for diffuse none and specular phong (they take none)");
  EXPECT_EQ(material_error(R"("diffuse": "none", "specular": "ggx", "fresnel": "glass")"),
            "\"fresnel\": \"glass\" is not for diffuse none and specular ggx (has: schlick, dielectric, conductor, none)");
  EXPECT_EQ(material_error(R"("diffuse": "none", "specular": "ggx", "alpha": 0.2, "roughness": 0.5)"),
            "\"alpha\": stands instead of \"roughness\" (alpha is its square; give one of them)");
  EXPECT_EQ(error_of([] { material_of(R"("diffuse": "burley", "specular": "ggx", "alpha": 0.2, "roughness": 0.5)"); }), "no error");
  EXPECT_TRUE(material_error(R"("diffuse": "lamber")").starts_with("\"diffuse\": no lobe \"lamber\" (has: auto, none, lambert, lambert_original, "));
  EXPECT_TRUE(material_error(R"("specular": "lambert")").starts_with("\"specular\": no lobe \"lambert\" (has: auto, none, phong_original, "));
}

TEST(Materials, AnAutomaticHalfTakesWhatAnyOfItsLobesTakes) {
  EXPECT_EQ(
      error_of([] { material_of(R"("metallic": 1, "ks": 0.5, "exponent": 3, "kd": 0.2, "k": 2, "shadowing": "v_groove", "distribution": "ggx")"); }),
      "no error");
  EXPECT_EQ(error_of([] { material_of(R"("diffuse": "lambert", "exponent": 3)"); }), "no error");
  EXPECT_TRUE(material_error(R"("specular": "ggx", "exponent": 3)")
                  .starts_with("\"exponent\": not a parameter of diffuse auto and specular ggx with fresnel schlick"));
}

TEST(Materials, WhatIsNoIdIsAName) {
  for (const std::string name : {"-1", "4294967296", "01", "x", "/world/torus", "1.0", " 1", "\u0440"}) {
    const MaterialFile file = read_string("{\"relume\": 1, \"materials\": {\"" + name + "\": {}}}");
    EXPECT_TRUE(file.by_id.empty());
    EXPECT_TRUE(file.by_name.contains(name)) << name;
  }
}

TEST(Materials, RefusesBadValues) {
  const std::string lobes = R"("diffuse": "plastic", "specular": "ggx", )";
  EXPECT_EQ(material_error(lobes + R"("alpha": 2)"), "\"alpha\": 2 is out of range (0.0001..1)");
  EXPECT_EQ(material_error(lobes + R"("albedo": [0.5, -0.1, 0.5])"), "\"albedo\": -0.1 is out of range (0..1)");
  EXPECT_EQ(material_error(lobes + R"("albedo": [0.5, 0.5])"), "\"albedo\": must be 1 or 3 numbers (has 2)");
  EXPECT_EQ(material_error(lobes + R"("alpha": [0.5, 0.5])"), "\"alpha\": must be a number (is an array)");
  EXPECT_EQ(material_error(lobes + R"("alpha": true)"), "\"alpha\": must be a number (is a boolean)");
  EXPECT_EQ(material_error(lobes + R"("nonlinear": 0.5)"), "\"nonlinear\": 0.5 is neither 0 nor 1 (false nor true)");
  EXPECT_EQ(material_error(lobes + R"("albedo": "red")"), "\"albedo\": must be numbers, \"layer:NAME\" or {\"texture\": FILE}");
  EXPECT_EQ(material_error(lobes + R"("albedo": "layer:")"), "\"albedo\": must be numbers, \"layer:NAME\" or {\"texture\": FILE}");
  EXPECT_EQ(material_error(lobes + R"("albedo": {"uv": "st"})"), "albedo: \"texture\" is missing");
  EXPECT_EQ(material_error(lobes + R"("albedo": {"texture": ""})"), "albedo: \"texture\": must name a file");
  EXPECT_EQ(material_error(lobes + R"("albedo": {"texture": "a.exr", "filter": "cubic"})"), "albedo: \"filter\": must be one of bilinear, nearest");
  EXPECT_EQ(material_error(lobes + R"("albedo": {"texture": "a.exr", "v": "left"})"), "albedo: \"v\": must be one of up, down");
  EXPECT_EQ(material_error(lobes + R"("albedo": {"texture": "a.exr", "wrap": 1})"), "albedo: unknown key \"wrap\" (has: texture, uv, filter, v)");
  EXPECT_EQ(material_error(R"("twosided": 1)"), "\"twosided\": must be true or false (is a number)");
  EXPECT_TRUE(material_error(R"("colour": 1)")
                  .starts_with("unknown key \"colour\" (has: diffuse, specular, shadowing, fresnel, distribution, twosided, albedo, kd, "));
  EXPECT_TRUE(material_error(R"("transmittance": 1)").starts_with("unknown key \"transmittance\" (has: "));
}

TEST(Materials, RefusesBadFiles) {
  EXPECT_EQ(file_error("[]"), "standard input:1: must be an object (is an array)");
  EXPECT_EQ(file_error("{\"materials\": {}}"), "standard input:1: \"relume\" is missing");
  EXPECT_EQ(file_error("{\"relume\": 1}"), "standard input:1: \"materials\" is missing");
  EXPECT_EQ(file_error("{\"relume\": 1, \"materials\": []}"), "standard input:1: materials: must be an object (is an array)");
  EXPECT_EQ(file_error("{\"relume\": 1, \"id\": \"a\"}"), "standard input:1: unknown key \"id\" (has: relume, ids, materials)");
  EXPECT_EQ(file_error("{\"relume\": 1, \"materials\": {\n\"\": {}}}"),
            "standard input:2: materials: \"\": must be an object's id (0..4294967295) or name, or \"default\"");
  EXPECT_EQ(file_error("{\"relume\": 1, \"materials\": {\"1\":\n 5}}"), "standard input:2: materials[\"1\"]: must be an object (is a number)");
}

TEST(SetParameter, SetsConstantsAndTerms) {
  Material material;
  for (const char* assignment :
       {"alpha=0.2", "albedo=0.5,0.4,0.3", "f0=0.04", "fresnel=none", "distribution=ggx", "shadowing=v_groove", "twosided=true", "nonlinear=1"})
    set_parameter(material, assignment);
  EXPECT_EQ(std::get<Numbers>(material.parameters.at("alpha")), Numbers{0.2});
  EXPECT_EQ(std::get<Numbers>(material.parameters.at("albedo")), (Numbers{0.5, 0.4, 0.3}));
  EXPECT_EQ(std::get<Numbers>(material.parameters.at("f0")), (Numbers{0.04, 0.04, 0.04}));
  EXPECT_EQ(std::get<Numbers>(material.parameters.at("nonlinear")), Numbers{1});
  EXPECT_EQ(material.fresnel, "none");
  EXPECT_EQ(material.distribution, "ggx");
  EXPECT_EQ(material.shadowing, "v_groove");
  EXPECT_EQ(material.twosided, true);
}

TEST(SetParameter, SaysWhatIsAllowed) {
  EXPECT_EQ(set_error("alpha"), "--set alpha: must be PARAM=VALUE");
  EXPECT_EQ(set_error("=1"), "--set =1: must be PARAM=VALUE");
  EXPECT_EQ(set_error("alpha=2"), "--set alpha=2: 2 is out of range (0.0001..1)");
  EXPECT_EQ(set_error("alpha=0.1,0.2"), "--set alpha=0.1,0.2: must be 1 number");
  EXPECT_EQ(set_error("albedo=0.1,0.2"), "--set albedo=0.1,0.2: must be 3 numbers");
  EXPECT_EQ(set_error("albedo=0.1,,0.2"), "--set albedo=0.1,,0.2: \"\" is not a number");
  EXPECT_EQ(set_error("albedo=0.1,0.2,0.3,"), "--set albedo=0.1,0.2,0.3,: \"\" is not a number");
  EXPECT_EQ(set_error("alpha="), "--set alpha=: \"\" is not a number");
  EXPECT_EQ(set_error("alpha=0.1x"), "--set alpha=0.1x: \"0.1x\" is not a number");
  EXPECT_EQ(set_error("alpha=nan"), "--set alpha=nan: \"nan\" is not a number");
  EXPECT_EQ(set_error("exponent=inf"), "--set exponent=inf: \"inf\" is not a number");
  EXPECT_EQ(set_error("twosided=maybe"), "--set twosided=maybe: must be true or false");
  EXPECT_EQ(set_error("fresnel=glass"), "--set fresnel=glass: no fresnel \"glass\" (has: schlick, dielectric, conductor, none)");
  EXPECT_TRUE(set_error("rough=1").starts_with("--set rough=1: no parameter \"rough\" (has: albedo, kd, "));
  EXPECT_TRUE(set_error("transmittance=1").starts_with("--set transmittance=1: no parameter \"transmittance\" (has: "));
}

TEST(Check, NamesThePlace) {
  Material material;
  material.diffuse = "lambert";
  material.specular = "none";
  EXPECT_EQ(error_of([&] { check(material, "options"); }), "no error");
  set_parameter(material, "exponent=5");
  EXPECT_EQ(error_of([&] { check(material, "options"); }),
            "options: \"exponent\": not a parameter of diffuse lambert and specular none (has: albedo)");
}

TEST(Materials, TheCorpusIsRead) {
  const std::filesystem::path corpus = std::filesystem::path(RELUME_CORPUS) / "mitsuba";
  if (!std::filesystem::exists(corpus)) GTEST_SKIP() << "the corpus is not beside the project";
  int files = 0;
  for (const auto& folder : std::filesystem::directory_iterator(corpus)) {
    const std::filesystem::path file = folder.path() / "materials.json";
    if (!std::filesystem::exists(file)) continue;
    ++files;
    EXPECT_EQ(error_of([&] {
                const MaterialFile materials = read_materials(file);
                EXPECT_EQ(materials.ids, "shape_index");
                EXPECT_FALSE(materials.by_id.empty()) << file;
              }),
              "no error");
  }
  EXPECT_GE(files, 40);
}

}  // namespace
}  // namespace relume
