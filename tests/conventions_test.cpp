// Conventions: who wrote a file, and which layer plays which role, from header and names alone; made-up headers, then the corpus.
#include "gbuffer/convention.h"

#include <ImfStringAttribute.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/made_up_exr.h"
#include "tests/reading_words.h"

namespace relume {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Texts = std::map<std::string, std::string>;

/// What names and header say, with no look at the data.
Reading named(const ExrFile& file) {
  const Convention& convention = convention_of(file, {});
  Reading reading;
  reading.convention = convention.name;
  const auto layers = layers_of(file);
  assign_roles(convention, file, layers, reading);
  return reading;
}

struct Written {
  const char* convention;
  Texts attributes;
  std::vector<std::string> channels;
  Texts roles;  ///< layers by role, as --map takes them
  Space normal_space = Space::world, position_space = Space::world;
};

void PrintTo(const Written& written, std::ostream* out) { *out << written.convention << " with " << written.channels.front(); }

std::vector<std::string> with(const std::vector<std::string>& layers, const char* letters) {
  std::vector<std::string> channels;
  for (const std::string& layer : layers)
    for (const char* letter = letters; *letter; ++letter) channels.push_back(layer + "." + *letter);
  return channels;
}

std::vector<std::string> operator+(std::vector<std::string> a, const std::vector<std::string>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

const std::vector<std::string> beauty{"R", "G", "B", "A"};

const Written files[] = {
    {"blender",
     {{"BlenderMultiChannel", "Blender V2.55.1 and newer"}},
     with({"ViewLayer.Normal", "ViewLayer.Position"}, "XYZ") +
         with({"ViewLayer.Combined", "ViewLayer.Diffuse Color", "ViewLayer.Glossy Color"}, "RGBA") +
         std::vector<std::string>{"ViewLayer.Depth.Z", "ViewLayer.Object Index.X", "ViewLayer.rough.X"},
     {{"normal", "Normal"},
      {"position", "Position"},
      {"albedo", "Diffuse Color"},
      {"glossy_albedo", "Glossy Color"},
      {"depth", "Depth"},
      {"ids", "Object Index"},
      {"roughness", "rough"},
      {"coverage", "Combined"}}},
    {"pbrt",
     {},
     beauty + with({"P", "N", "Ns"}, "XYZ") + with({"Albedo"}, "RGB") + std::vector<std::string>{"dzdx", "dzdy", "u", "v"},
     {{"normal", "Ns"}, {"position", "P"}, {"albedo", "Albedo"}, {"uv", "uv"}}},
    {"pbrt",
     {},
     {"Px", "Py", "Pz", "Nx", "Ny", "Nz", "Nsx", "Nsy", "Nsz", "dzdx", "dzdy", "u", "v"},
     {{"normal", "Ns"}, {"position", "P"}, {"uv", "uv"}}},
    {"mitsuba",
     {{"generatedBy", "Mitsuba version 3.9.1"}},
     beauty + with({"my position", "my normals"}, "XYZ") + std::vector<std::string>{"dd.y.T", "s.I"},
     {{"normal", "my normals"}, {"position", "my position"}, {"depth", "dd.y"}, {"ids", "s"}}},
    {"arnold",
     {{"arnold/version", "7.1"},
      {"arnold/aovs/where/source", "P"},
      {"arnold/aovs/which way/source", "N"},
      {"arnold/aovs/tint/source", "diffuse_albedo"},
      {"arnold/aovs/key/source", "C<RD>.*"}},
     beauty + with({"where", "which way"}, "XYZ") + with({"tint", "key", "diffuse"}, "RGB") + std::vector<std::string>{"Z", "metalness"},
     {{"normal", "which way"}, {"position", "where"}, {"albedo", "tint"}, {"depth", "Z"}, {"metallic", "metalness"}, {"coverage", "RGBA"}}},
    {"vray",
     {{"vrayInfo/vrayversion", "V-Ray 5"}},
     beauty + with({"VRayNormals", "VRayBumpNormals"}, "XYZ") + with({"VRayLighting", "VRayRawLighting"}, "RGB") +
         std::vector<std::string>{"VRayZDepth.R", "VRayMtlReflectGlossiness.R"},
     {{"normal", "VRayBumpNormals"},
      {"depth", "VRayZDepth"},
      {"glossiness", "VRayMtlReflectGlossiness"},
      {"diffuse_light", "VRayLighting"},
      {"diffuse_raw_light", "VRayRawLighting"}},
     Space::view_ray},
    {"vray",
     {},
     with({"VRayDiffuseFilter", "VRayLighting", "VRayRawLighting"}, "RGB") + with({"world_normal"}, "XYZ"),
     {{"normal", "world_normal"}, {"albedo", "VRayDiffuseFilter"}, {"diffuse_light", ""}}},
    {"renderman", {}, with({"__Nworld", "__Pworld", "albedo"}, "rgb"), {{"normal", "__Nworld"}, {"position", "__Pworld"}, {"albedo", "albedo"}}},
    {"renderman", {}, with({"Nn", "P", "albedo"}, "rgb"), {{"normal", "Nn"}, {"position", "P"}}, Space::camera, Space::camera},
    {"karma",
     {{"husk:render_stats", "{}"}},
     beauty + with({"N", "N_camera", "P_camera", "basecolor"}, "xyz") + std::vector<std::string>{"hitdist.hitdist"},
     {{"normal", "N"}, {"position", "P_camera"}, {"depth", "hitdist"}},
     Space::world,
     Space::camera},
    {"redshift",
     {},
     with({"N", "P", "DiffuseLighting", "SpecularLighting", "DiffuseLightingRaw"}, "rgb"),
     {{"normal", "N"}, {"position", "P"}, {"diffuse_light", "DiffuseLighting"}, {"diffuse_raw_light", "DiffuseLightingRaw"}}},
    {"unreal",
     {{"unreal/cameraName", "c"}},
     beauty + with({"FinalImageMovieRenderQueue_WorldNormal", "FinalImageBaseColor"}, "RGB") +
         std::vector<std::string>{"FinalImageMovieRenderQueue_WorldDepth.R", "FinalImageRoughness.R"},
     {{"normal", "FinalImageMovieRenderQueue_WorldNormal"},
      {"albedo", "FinalImageBaseColor"},
      {"depth", "FinalImageMovieRenderQueue_WorldDepth"},
      {"roughness", "FinalImageRoughness"}}},
    {"relume_bake",
     {{"software", "relume bake"}},
     with({"P", "N", "Ng"}, "XYZ") + with({"albedo"}, "RGB") + std::vector<std::string>{"A", "Z", "id", "triangle", "roughness"},
     {{"position", "P"}, {"normal", "N"}, {"base_normal", "Ng"}, {"albedo", "albedo"}, {"depth", "Z"}, {"ids", "id"}, {"primitive_ids", "triangle"}}},
    {"delight",
     {{"software", "3Delight 2.9"}},
     with({"N.camera", "P.world", "albedo"}, "XYZ"),
     {{"normal", "N.camera"}, {"position", "P.world"}},
     Space::camera},
    {"corona",
     {},
     with({"CGeometry_NormalsShading", "CGeometry_WorldPosition", "CShading_Albedo"}, "RGB"),
     {{"normal", "CGeometry_NormalsShading"}, {"position", "CGeometry_WorldPosition"}, {"albedo", "CShading_Albedo"}}},
    {"luxcore",
     {},
     with({"SHADING_NORMAL", "POSITION", "GEOMETRY_NORMAL"}, "XYZ") + std::vector<std::string>{"DEPTH.Z", "OBJECT_ID.X"},
     {{"normal", "SHADING_NORMAL"}, {"base_normal", "GEOMETRY_NORMAL"}, {"position", "POSITION"}, {"depth", "DEPTH"}, {"ids", "OBJECT_ID"}}},
    {"octane",
     {},
     with({"Shading normal", "Position", "Diffuse filter"}, "RGB") + std::vector<std::string>{"Z-Depth.R"},
     {{"normal", "Shading normal"}, {"position", "Position"}, {"albedo", "Diffuse filter"}, {"depth", "Z-Depth"}}},
    {"mantra",
     {},
     with({"N", "P", "basecolor"}, "rgb") + std::vector<std::string>{"Pz"},
     {{"normal", "N"}, {"position", "P"}, {"depth", "Pz"}, {"albedo", "basecolor"}},
     Space::camera,
     Space::camera},
    {"moonray", {{"Software", "MoonRay"}}, with({"normal", "position"}, "uvw"), {{"normal", "normal"}, {"position", "position"}}},
    {"iray",
     {{"comments", "Generated by Iray for Maya"}},
     with({"normal"}, "XYZ") + std::vector<std::string>{"depth.Z"},
     {{"normal", "normal"}, {"depth", "depth"}},
     Space::camera},
    {"cinema4d", {{"Software", "Cinema 4D"}}, with({"World Coordinate", "Normal"}, "RGB"), {{"normal", "Normal"}, {"position", "World Coordinate"}}},
    {"gaffer", {}, with({"normal", "position", "diffuse_color", "glossy_color"}, "RGB"), {{"normal", "normal"}, {"albedo", "diffuse_color"}}},
    {"scanline", {}, beauty + std::vector<std::string>{"NX", "NY", "NZ", "Z", "materialID"}, {{"normal", "N"}, {"depth", "Z"}}, Space::camera},
    {"nuke",
     {{"nuke/version", "14"}},
     {"worldNormals.red", "worldNormals.green", "worldNormals.blue", "depth.Z"},
     {{"normal", "worldNormals"}, {"depth", "depth"}}},
    {"vray", {{"nuke/version", "14"}}, {"VRayNormals.X", "VRayNormals.Y", "VRayNormals.Z"}, {{"normal", "VRayNormals"}}, Space::view_ray},
    {"arnold", {{"nuke/version", "14"}, {"exr/arnold/version", "7"}}, with({"N"}, "XYZ"), {{"normal", "N"}}},
    {"oiio",
     {{"Software", "OpenImageIO 2.4.7 : oiiotool"}},
     with({"nrm_cam", "pos"}, "XYZ"),
     {{"normal", "nrm_cam"}, {"position", "pos"}},
     Space::camera},
    {"generic",
     {},
     with({"Nrm_ws", "position_ws", "N_camera", "Basecolor"}, "rgb") + std::vector<std::string>{"Smoothness", "IOR", "objectID"},
     {{"normal", "Nrm_ws"}, {"position", "position_ws"}, {"albedo", "Basecolor"}, {"glossiness", "Smoothness"}, {"ior", "IOR"}, {"ids", "objectID"}}},
};

class Wrote : public testing::TestWithParam<Written> {};
TEST_P(Wrote, IsKnownWithItsRoles) {
  const Written& w = GetParam();
  const MadeUpExr made(
      {{"", "", w.channels}}, 2, 2, [](const std::string&, int, int) { return 0.0; },
      [&](Imf::Header& header) {
        for (const auto& [name, text] : w.attributes) header.insert(name, Imf::StringAttribute(text));
      });
  const Reading reading = named(ExrFile(made.file));
  EXPECT_EQ(reading.convention, w.convention);
  for (const auto& [role, name] : w.roles) EXPECT_EQ(layer(reading, role), name) << role;
  EXPECT_EQ(reading.normal_space, w.normal_space);
  EXPECT_EQ(reading.position_space, w.position_space);
}

INSTANTIATE_TEST_SUITE_P(Files, Wrote, testing::ValuesIn(files));

TEST(Conventions, EachHasAFileOfItsOwn) {
  std::set<std::string> tried;
  for (const Written& w : files) tried.insert(w.convention);
  for (const Convention& convention : conventions()) EXPECT_TRUE(tried.contains(convention.name)) << convention.name << " has no made-up file above";
}

TEST(Conventions, EvidenceSaysHowSure) {
  const auto evidence = [](const Texts& attributes) {
    const MadeUpExr made(
        {{"", "", with({"N", "P"}, "XYZ")}}, 2, 2, [](const std::string&, int, int) { return 0.0; },
        [&](Imf::Header& header) {
          for (const auto& [name, text] : attributes) header.insert(name, Imf::StringAttribute(text));
        });
    const ExrFile file(made.file);
    return evidence_for(convention_of(file, {}), file, layers_of(file)).words;
  };
  EXPECT_EQ(evidence({{"husk:command", "x"}}), "header attribute husk:command");
  EXPECT_EQ(evidence({{"Software", "Blender \033[2J"}}), "header attribute Software = \"Blender \\x1b[2J\"");
  EXPECT_NE(evidence({{"nuke/version", "14"}}).find("wrote it last"), std::string::npos);
  EXPECT_EQ(evidence({}), "no renderer's marks: common names");
}

TEST(Conventions, ArnoldsFiltersTellAverages) {
  for (const char* filter : {"box_filter", "closest_filter"}) {
    const MadeUpExr made(
        {{"", "", with({"N", "P"}, "XYZ")}}, 2, 2, [](const std::string&, int, int) { return 0.0; },
        [&](Imf::Header& header) { header.insert("arnold/aovs/P/filter", Imf::StringAttribute(filter)); });
    EXPECT_EQ(named(ExrFile(made.file)).position_premultiplied, std::string(filter) == "box_filter");
  }
}

TEST(Conventions, LobesFollowWhatIsStored) {
  const auto read = [](const std::vector<std::string>& channels) {
    const MadeUpExr made({{"", "", channels}}, 2, 2, [](const std::string&, int, int) { return 0.0; });
    return named(ExrFile(made.file));
  };
  EXPECT_EQ(read({"N.X", "rough"}).default_diffuse, "gltf");
  EXPECT_EQ(read({"N.X", "gloss"}).default_specular, "ggx");
  const Reading plain = read({"N.X"});
  EXPECT_EQ(plain.default_diffuse + "+" + plain.default_specular, "lambert+none");
  EXPECT_NE(notes(plain).find("no roughness layer"), std::string::npos);
}

TEST(Conventions, PartsWithoutABeauty) {
  const MadeUpExr made({{"rgba", "", {"R", "G", "B", "A"}}, {"world_normal", "", {"X", "Y", "Z"}}, {"depth", "", {"Z"}}, {"rough", "", {"Y"}}}, 2, 2,
                       [](const std::string&, int, int) { return 0.0; });
  const Reading reading = named(ExrFile(made.file));
  EXPECT_EQ(reading.roles.at("normal").part, 1);
  EXPECT_EQ(reading.roles.at("depth").part, 2);
  EXPECT_EQ(reading.roles.at("roughness").channels, std::vector<std::string>{"Y"});
  EXPECT_EQ(reading.roles.at("coverage").channels, std::vector<std::string>{"A"});
}

const fs::path folder = fs::path(RELUME_CORPUS) / "conventions";

json answer_of(const fs::path& file) { return json::parse(std::ifstream(fs::path(file).replace_extension(".answer.json"))); }

std::vector<fs::path> answered() {
  std::vector<fs::path> all;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".exr" && fs::exists(fs::path(entry.path()).replace_extension(".answer.json"))) all.push_back(entry.path());
  return all;
}

TEST(Conventions, RolesOfTheCorpus) {
  if (!fs::exists(folder)) GTEST_SKIP() << "the corpus is not beside the project: " << folder;
  const std::map<std::string, std::string> wrote{{"arnold_box_half", "arnold"},
                                                 {"arnold_colour_aov", "arnold"},
                                                 {"arnold_multipart", "arnold"},
                                                 {"bad_pixels", "arnold"},
                                                 {"blender4", "blender"},
                                                 {"delight_camera", "delight"},
                                                 {"karma", "karma"},
                                                 {"mitsuba3", "mitsuba"},
                                                 {"nuke_crop_decreasing", "nuke"},
                                                 {"pbrt4_world", "pbrt"},
                                                 {"redshift", "redshift"},
                                                 {"renderman_rgb", "renderman"},
                                                 {"unreal", "unreal"},
                                                 {"vray_max_signed", "vray"},
                                                 {"vray_maya_unsigned", "vray"}};
  EXPECT_EQ(answered().size(), wrote.size());
  for (const fs::path& path : answered()) {
    SCOPED_TRACE(path.string());
    const ExrFile file(path);
    const Reading reading = named(file);
    EXPECT_EQ(reading.convention, wrote.at(path.stem().string()));
    const auto answer = answer_of(path);
    for (const auto& [role, truth] : answer["layers"].items()) {
      if (role == "beauty") continue;
      ASSERT_TRUE(reading.roles.contains(role)) << role;
      EXPECT_EQ(reading.roles.at(role).channels, truth["channels"].get<std::vector<std::string>>()) << role;
      if (truth.contains("part")) {
        EXPECT_EQ(file.parts()[std::size_t(reading.roles.at(role).part)].name, truth["part"]) << role;
      }
      const std::string space = truth.value("space", "world");
      const Space expected = space == "vray" ? Space::view_ray : space == "camera_forward" || space == "camera" ? Space::camera : Space::world;
      if (role == "normal") {
        EXPECT_EQ(reading.normal_space, expected);
      }
      if (role == "position") {
        EXPECT_EQ(reading.position_space, expected);
      }
    }
    const bool rough = answer_of(path)["layers"].contains("roughness");
    EXPECT_EQ(reading.default_diffuse + "+" + reading.default_specular, rough ? "gltf+ggx" : "lambert+none");
  }
}

}  // namespace
}  // namespace relume
