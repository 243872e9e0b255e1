// Files understood: names, cameras, Mitsuba's bumps, and what the user may say against what is found out (the corpus: reading_corpus_test).
#include "gbuffer/reading.h"

#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>

#include "gbuffer/error.h"
#include "tests/made_up_exr.h"
#include "tests/reading_words.h"

namespace relume {
namespace {

namespace fs = std::filesystem;

/// A dome seen by a camera at (0, 0, 4) that looks down -z, 90 degrees wide and high.
double dome(const std::string& channel, int x, int y) {
  const double u = (x + 0.5) / 16 - 1, v = 1 - (y + 0.5) / 16, bulge = 1 - 0.3 * (u * u + v * v), depth = 4 - bulge;
  const glm::dvec3 p{u * depth, v * depth, bulge}, n = glm::normalize(glm::dvec3(0.6 * u, 0.6 * v, 1));
  const int axis = channel.back() == 'X' ? 0 : channel.back() == 'Y' ? 1 : 2;
  return channel.starts_with("N") || channel.find("ormal") != std::string::npos ? n[axis] : p[axis];
}

const std::vector<std::string> plain{"N.X", "N.Y", "N.Z", "P.X", "P.Y", "P.Z"};

TEST(Reading, GenericNamesAndRecoveredCamera) {
  const MadeUpExr made({{"", "", plain}}, 32, 32, dome);
  const Reading reading = understand(ExrFile(made.file), {});
  EXPECT_EQ(reading.convention, "generic");
  EXPECT_EQ(layer(reading, "normal"), "N");
  ASSERT_TRUE(reading.camera) << notes(reading);
  EXPECT_LT(glm::distance(reading.camera->eye(), {0, 0, 4}), 1e-4);
  EXPECT_NEAR(reading.camera->vertical_fov, 90, 1e-3);
}

TEST(Reading, HeaderCameraInEitherStorage) {
  for (const bool transposed : {false, true}) {
    const MadeUpExr made({{"", "", plain}}, 32, 32, dome, [&](Imf::Header& header) {
      Imath::M44f camera(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 4, 1);  // row vectors, z forward
      Imf::addWorldToCamera(header, transposed ? camera.transposed() : camera);
    });
    const Reading reading = understand(ExrFile(made.file), {});
    ASSERT_TRUE(reading.camera);
    EXPECT_EQ(reading.camera->source, transposed ? "worldToCamera of the header, stored transposed" : "worldToCamera of the header");
    EXPECT_LT(glm::distance(reading.camera->eye(), {0, 0, 4}), 1e-6);
    EXPECT_NEAR(reading.camera->vertical_fov, 90, 1e-3);
  }
}

TEST(Reading, HeaderCameraThatDidNotSeeTheFileGivesWay) {
  const MadeUpExr made({{"", "", plain}}, 32, 32, dome,
                       [&](Imf::Header& header) { Imf::addWorldToCamera(header, Imath::M44f(0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 7, 1)); });
  const Reading reading = understand(ExrFile(made.file), {});
  ASSERT_TRUE(reading.camera);
  EXPECT_LT(glm::distance(reading.camera->eye(), {0, 0, 4}), 1e-4);
  EXPECT_NE(notes(reading).find("recovered"), std::string::npos) << notes(reading);
}

TEST(Reading, GivenCameraWinsButIsChecked) {
  const MadeUpExr made({{"", "", plain}}, 32, 32, dome);
  ReadingOptions options;
  options.camera = Camera{};
  options.camera->world_from_camera[3] = {0, 0, 4, 1};
  EXPECT_EQ(notes(understand(ExrFile(made.file), options)).find("warning"), std::string::npos);
  options.camera->world_from_camera[3] = {2, 0, 5, 1};
  const Reading reading = understand(ExrFile(made.file), options);
  EXPECT_EQ(reading.camera->eye(), glm::dvec3(2, 0, 5));
  EXPECT_NE(notes(reading).find("warning: the camera given"), std::string::npos) << notes(reading);
}

std::string message_of(const fs::path& file, const ReadingOptions& options) {
  try {
    understand(ExrFile(file), options);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind, ErrorKind::input);
    return error.what();
  }
  return "no error";
}

TEST(Reading, MappedLayers) {
  const MadeUpExr made({{"", "", {"My Normal.X", "My Normal.Y", "My Normal.Z", "where.X", "where.Y", "where.Z", "gloss.R"}}}, 32, 32, dome);
  const std::string missing = message_of(made.file, {});
  EXPECT_NE(missing.find("part 0: no normal layer (looked for"), std::string::npos) << missing;
  EXPECT_NE(missing.find("--map normal=LAYER names one)"), std::string::npos) << missing;
  ReadingOptions options;
  options.map = {{"normal", "my_normal"}, {"position", "Where"}, {"roughness", "gloss"}};
  const Reading reading = understand(ExrFile(made.file), options);
  EXPECT_EQ(layer(reading, "normal"), "My Normal");
  EXPECT_EQ(reading.roles.at("roughness").channels, std::vector<std::string>{"gloss.R"});
  EXPECT_EQ(find_layer(ExrFile(made.file), reading, "GLOSS").layer, "gloss");
  options.map["normal"] = "gloss";
  EXPECT_NE(message_of(made.file, options).find("no layer \"gloss\" for normal with three components (there are: My Normal, where)"),
            std::string::npos)
      << message_of(made.file, options);
}

TEST(Reading, ViewLayersByName) {
  std::vector<std::string> channels;
  for (const char* layer : {"Beauty", "Set only"})
    for (const char* pass :
         {"Combined.R", "Normal.X", "Normal.Y", "Normal.Z", "Position.X", "Position.Y", "Position.Z", "DiffCol.R", "DiffCol.G", "DiffCol.B"})
      channels.push_back(std::string(layer) + "." + pass);
  const MadeUpExr made({{"", "", channels}}, 32, 32, dome);
  const Reading first = understand(ExrFile(made.file), {});
  EXPECT_EQ(first.view_layer, "Beauty");
  EXPECT_NE(notes(first).find("Set only"), std::string::npos);
  ReadingOptions options;
  options.view_layer = "Set only";
  const Reading second = understand(ExrFile(made.file), options);
  EXPECT_EQ(second.roles.at("normal").channels.front(), "Set only.Normal.X");
  options.map["albedo"] = "Set only.DiffCol";
  EXPECT_EQ(understand(ExrFile(made.file), options).roles.at("albedo").channels.size(), 3u);
  options.view_layer = "Other";
  EXPECT_NE(message_of(made.file, options).find("no view layer \"Other\" (there are: Beauty, Set only)"), std::string::npos);
  options.view_layer.clear();
  options.view = "left";
  EXPECT_NE(message_of(made.file, options).find("no view \"left\" (the file has none)"), std::string::npos);
}

/// The dome again as Mitsuba writes it: facets of `size` pixels (0: none), shading normals by `relief`.
enum class Relief { smooth, bumped, local };
Reading mitsuba_dome(int size, Relief relief, int shapes = 1) {
  const std::vector<std::string> channels{"position.X",  "position.Y",   "position.Z",    "sh_normal.X",  "sh_normal.Y",
                                          "sh_normal.Z", "geo_normal.X", "geo_normal.Y",  "geo_normal.Z", "dp_du.X",
                                          "dp_du.Y",     "dp_du.Z",      "shape_index.I", "prim_index.I"};
  const auto value = [&](const std::string& channel, int x, int y) -> double {
    const int middle_x = size ? x / size * size + size / 2 : x, middle_y = size ? y / size * size + size / 2 : y;
    const auto normal = [](int u, int v) { return glm::dvec3(dome("N.X", u, v), dome("N.Y", u, v), dome("N.Z", u, v)); };
    const glm::dvec3 geo = normal(middle_x, middle_y), bump{0.2 * std::sin(x * 1.7), 0.2 * std::cos(y * 2.1), 0};
    const bool bumpy = relief == Relief::bumped && (shapes == 1 || x < 16);
    const glm::dvec3 sh = relief == Relief::local ? glm::normalize(glm::dvec3(0, 0, 1) + bump)
                          : bumpy                 ? glm::normalize(geo + bump)
                          : size                  ? normal(x, y)
                                                  : geo;
    const int axis = channel.back() == 'X' ? 0 : channel.back() == 'Y' ? 1 : 2;
    if (channel == "shape_index.I") return shapes == 1 || x < 16 ? 7 : 8;
    if (channel == "prim_index.I") return size ? (middle_y / size) * 100 + middle_x / size : 0;
    if (channel.starts_with("dp_du")) return axis == 0 ? 1 : 0;
    return channel.starts_with("geo") ? geo[axis] : channel.starts_with("sh") ? sh[axis] : dome(channel, x, y);
  };
  const MadeUpExr made({{"", "", channels}}, 32, 32, value,
                       [](Imf::Header& header) { header.insert("generatedBy", Imf::StringAttribute("Mitsuba version 3.9.1")); });
  return understand(ExrFile(made.file), {});
}

TEST(Reading, MitsubaSmoothMeshesAreNotBumped) {
  for (const int size : {2, 4, 8}) {
    const Reading mesh = mitsuba_dome(size, Relief::smooth);
    EXPECT_EQ(mesh.bump_shadowing, BumpShadowing::none) << "facets of " << size << " pixels\n" << notes(mesh);
    EXPECT_EQ(layer(mesh, "base_normal"), "");
    const Reading bumped = mitsuba_dome(size, Relief::bumped);
    EXPECT_NE(bumped.bump_shadowing, BumpShadowing::none) << "flat facets of " << size << " pixels under a normal map\n" << notes(bumped);
  }
  EXPECT_EQ(mitsuba_dome(0, Relief::smooth).bump_shadowing, BumpShadowing::none);
}

TEST(Reading, MitsubaBumpsOfSomeShapes) {
  const Reading reading = mitsuba_dome(0, Relief::bumped, 2);
  EXPECT_NE(reading.bump_shadowing, BumpShadowing::none);
  EXPECT_EQ(reading.bumped_ids, std::vector<std::uint32_t>{7});
  EXPECT_FALSE(reading.normal_in_tangent_frame);
  EXPECT_TRUE(mitsuba_dome(0, Relief::local).normal_in_tangent_frame);
}

TEST(Reading, OldPbrtNames) {
  std::vector<std::string> channels{"dzdx", "dzdy"};
  for (const char* vector : {"P", "N", "Ns"})
    for (const char* axis : {"x", "y", "z"}) channels.push_back(std::string(vector) + axis);
  const MadeUpExr made({{"", "", channels}}, 32, 32, [](const std::string& channel, int x, int y) {
    std::string upper = channel;
    upper.back() = char(std::toupper(upper.back()));
    return dome(upper, x, y);
  });
  const Reading reading = understand(ExrFile(made.file), {});
  EXPECT_EQ(reading.convention, "pbrt");
  EXPECT_EQ(reading.roles.at("normal").channels, (std::vector<std::string>{"Nsx", "Nsy", "Nsz"}));
  EXPECT_EQ(reading.roles.at("position").channels, (std::vector<std::string>{"Px", "Py", "Pz"}));
}

TEST(Reading, ConventionByName) {
  const MadeUpExr made({{"", "", plain}}, 32, 32, dome);
  ReadingOptions options;
  options.convention = "blinder";
  EXPECT_NE(message_of(made.file, options).find("no convention \"blinder\" (there are: blender, "), std::string::npos);
  options.convention = "mitsuba";
  EXPECT_EQ(understand(ExrFile(made.file), options).facing, Facing::one_sided);
}

}  // namespace
}  // namespace relume
