// Light linking and materials by name, through the program: what a linked light adds is the objects' share of what it adds unlinked.
#include "host/light_links.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>

#include "gbuffer/cryptomatte_id.h"
#include "tests/channels.h"
#include "tests/made_up_exr.h"
#include "tests/make_gbuffer.h"
#include "tests/run_program.h"

namespace relume {
namespace {

const std::string blender = std::string(RELUME_SOURCE) + "/tests/data/corpus/blender/b5-interleaved/gbuffer.exr";
const std::string everything = R"(["Floor","Suzanne","Sphere","Torus","Cube","Capsule"])";
const std::string sun = R"({"type": "directional", "name": "sun", "direction": [0.3, 0.5, -1], "intensity": [2, 1, 3])";
const std::string bulb = R"({"type": "point", "name": "bulb", "position": [1, -2, 4], "intensity": 90)";
const std::string sky = R"({"type": "ambient", "name": "sky", "intensity": 0.3)";

class Links : public testing::Test {
 protected:
  std::string in(const std::string& name) const { return (folder_ / name).string(); }
  std::string put(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return in(name);
  }

  /// `lights`: the text within the rig's array.
  ProgramRun run(const std::string& file, const std::string& lights, std::vector<std::string> options = {}, const std::string& rig_ids = {}) const {
    const std::string ids = rig_ids.empty() ? "" : "\"ids\": \"" + rig_ids + "\", ";
    const std::string rig = put("rig.json", "{\"relume\": 1, " + ids + "\"lights\": [" + lights + "]}");
    options.insert(options.begin(), {"shade", file, "-o", in("out.exr"), "--overwrite", "--quiet", "--lights", rig});
    if (std::find(options.begin(), options.end(), "--device") == options.end()) options.insert(options.end(), {"--device", "twin"});
    return run_program(options);
  }
  Channels shade(const std::string& file, const std::string& lights, const std::vector<std::string>& options = {},
                 const std::string& ids = {}) const {
    const ProgramRun result = run(file, lights, options, ids);
    EXPECT_EQ(result.code, 0) << result.err;
    return result.code == 0 ? read_channels(in("out.exr")) : Channels{};
  }
  /// The sphere (id 1) over the floor (id 2).
  std::string plain_file() const {
    MadeUpGBuffer made;
    made.with({"albedo.R", "albedo.G", "albedo.B", "id"});
    write_gbuffer(folder_ / "plain.exr", made);
    return in("plain.exr");
  }

  TemporaryFolder folder_;
};

/// Largest difference, relative to the brightest value of `b`.
double difference(const Channels& a, const Channels& b) {
  double largest = a.size() == b.size() && !a.empty() ? 0 : INFINITY, peak = 0;
  for (const auto& [name, values] : b)
    for (std::size_t i = 0; i < values.size(); ++i) {
      peak = std::max(peak, std::fabs(double(values[i])));
      largest = std::max(largest, std::fabs(double(values[i]) - (a.contains(name) ? a.at(name)[i] : INFINITY)));
    }
  return largest / peak;
}

double sum_of(const std::vector<float>& values) {
  double sum = 0;
  for (const float v : values) sum += double(v);
  return sum;
}

constexpr double rounding = 1e-6;  // a few roundings of single precision

TEST_F(Links, AllObjectsAreAsNone) {
  const std::vector<std::string> layers{"--layers", "diffuse,specular,ambient,lights"};
  const std::string all = ", \"include\": " + everything + "}";
  const Channels unlinked = shade(blender, sun + "}," + bulb + "}," + sky + "}", layers);
  const Channels linked = shade(blender, sun + all + "," + bulb + all + "," + sky + all, layers);
  EXPECT_GT(sum_of(unlinked.at("R")), 100);
  EXPECT_LT(difference(linked, unlinked), rounding);
}

TEST_F(Links, IncludedAndExcludedAddUp) {
  const std::string some = "[\"Cube\", \"Floor\"]}";
  const Channels unlinked = shade(blender, sun + "}," + sky + "}");
  const Channels split = shade(blender, sun + ", \"include\": " + some + "," + sun + ", \"exclude\": " + some + "," + sky + ", \"exclude\": " + some +
                                            "," + sky + ", \"include\": " + some);
  EXPECT_LT(difference(split, unlinked), rounding);
}

/// What the program should find at each pixel.
struct Found {
  Found(const std::string& path, const std::vector<std::string>& called)
      : file(path),
        reading(understand(file, {})),
        objects(file, reading, "", true),
        gbuffer(read_gbuffer(file, reading, reading.data_window, objects.roles(), 0)) {
    const std::vector<std::uint32_t> all = objects.ids_of(called, "test");
    ids.insert(all.begin(), all.end());
  }
  bool shows_surface(std::size_t i) const { return gbuffer.planes.plane(gbuffer.coverage.first)[i] > 0; }

  ExrFile file;
  Reading reading;
  ObjectIds objects;
  GBuffer gbuffer;
  std::set<std::uint32_t> ids;
};

/// A wall before an orthographic camera; from left to right "torus" covers less and "wall" more of each pixel.
double shared_pixels(const std::string& channel, int x, int y) {
  if (channel == "P.X") return (x - 7.5) / 4;
  if (channel == "P.Y") return -(y - 7.5) / 4;
  if (channel == "P.Z") return -5 - 0.01 * x * y;
  if (channel == "N.Z") return 1;
  if (channel == "Crypto00.R" || channel == "Crypto00.B")
    return double(std::bit_cast<float>(cryptomatte_id(channel.back() == 'R' ? "torus" : "wall")));
  return channel == "Crypto00.G" ? 0.9 - 0.05 * x : channel == "Crypto00.A" ? 0.05 * x : 0;
}

TEST_F(Links, ALinkedLightIsItsObjectsShare) {
  const MadeUpExr made({{"", "", {"P.X", "P.Y", "P.Z", "N.X", "N.Y", "N.Z", "Crypto00.R", "Crypto00.G", "Crypto00.B", "Crypto00.A"}}}, 16, 16,
                       shared_pixels);
  const std::string camera = put("camera.json", R"({"relume": 1, "camera": {"type": "orthographic", "height": 4,
                                 "world_from_camera": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]}, "lights": []})");
  const Found torus(made.file.string(), {"torus"});
  const std::vector<float> share = torus.objects.shares(torus.gbuffer, torus.ids);
  Channels expected = shade(made.file.string(), sun + "}," + sky + "}", {"--camera", camera});
  EXPECT_GT(sum_of(expected.at("G")), 10);
  for (std::size_t i = 0; i < share.size(); ++i) {
    EXPECT_NEAR(share[i], 1 - 0.05 * double(i % 16) / 0.9, 1e-6);
    for (const char* c : {"R", "G", "B"}) expected.at(c)[i] *= share[i];
  }
  const std::string linked = ", \"include\": [\"torus\"]}";
  EXPECT_LT(difference(shade(made.file.string(), sun + linked + "," + sky + linked, {"--camera", camera}), expected), rounding);
}

TEST_F(Links, LayersAddUp) {
  const Channels image = shade(blender, sun + ", \"include\": [\"Cube\"]}," + bulb + "}," + sky + ", \"exclude\": [\"Floor\"]}",
                               {"--layers", "diffuse,specular,ambient,lights"});
  for (const std::string c : {"R", "G", "B"})
    for (std::size_t i = 0; i < image.at(c).size(); ++i) {
      const float total = image.at(c)[i], ambient = image.at("ambient." + c)[i];
      EXPECT_NEAR(image.at("diffuse." + c)[i] + image.at("specular." + c)[i] + ambient, total, 1e-6 * (1 + total));
      EXPECT_NEAR(image.at("light.sun." + c)[i] + image.at("light.bulb." + c)[i] + ambient, total, 1e-6 * (1 + total));
    }
  EXPECT_GT(sum_of(image.at("light.sun.R")), 10);
}

TEST_F(Links, BandsAndDevicesAgree) {
  const std::string lights = sun + ", \"include\": [\"Cube\"]}," + bulb + "}," + sky + ", \"exclude\": [\"Floor\"]}";
  const Channels whole = shade(blender, lights);
  EXPECT_EQ(difference(shade(blender, lights, {"--memory", "700K"}), whole), 0);
  if (run_program({"devices"}).out.find("Portable Computing Language") != std::string::npos) {
    EXPECT_LT(difference(shade(blender, lights, {"--device", "Portable"}), whole), rounding);
  }
}

TEST_F(Links, PlainIds) {
  const std::string file = plain_file();
  const std::string light = R"({"type": "directional", "direction": [0.2, -1, -1], "intensity": 1)";
  const Channels unlinked = shade(file, light + "}");
  const Channels sphere = shade(file, light + ", \"include\": [1]}"), floor = shade(file, light + ", \"exclude\": [\"1\"]}");
  MadeUpGBuffer made;
  int lit = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const std::size_t i = std::size_t(64 * y + x);
      const int id = scene_at(made, x, y).id;
      EXPECT_EQ(sphere.at("R")[i], id == 1 ? unlinked.at("R")[i] : 0.0f);
      EXPECT_EQ(floor.at("R")[i], id == 2 ? unlinked.at("R")[i] : 0.0f);
      lit += id == 1 && sphere.at("R")[i] > 0;
    }
  EXPECT_GT(lit, 500);
}

/// The mean irradiance that an ambient light's fraction is of counts a linked light where it shines.
TEST_F(Links, FractionsFollowTheLinks) {
  const std::string file = plain_file();
  const std::string light = R"({"type": "directional", "direction": [0, -1, -1], "intensity": 1)",
                    fraction = R"({"type": "ambient", "fraction": 0.5)";
  const std::vector<std::string> layers{"--layers", "ambient"};
  const double all = sum_of(shade(file, light + "}," + fraction + "}", layers).at("ambient.R"));
  const double sphere = sum_of(shade(file, light + ", \"include\": [1]}," + fraction + "}", layers).at("ambient.R"));
  const double floor = sum_of(shade(file, light + ", \"include\": [2]}," + fraction + "}", layers).at("ambient.R"));
  EXPECT_GT(sphere, 0.05 * all);
  EXPECT_GT(floor, 0.05 * all);
  EXPECT_NEAR(sphere + floor, all, 1e-5 * all);
  const Channels on_floor = shade(file, light + "}," + fraction + ", \"include\": [2]}", layers);
  EXPECT_LT(sum_of(on_floor.at("ambient.R")), 0.9 * all);
  EXPECT_EQ(on_floor.at("ambient.R")[32 * 64 + 32], 0);  // the sphere's middle
}

TEST_F(Links, MaterialsByName) {
  const auto materials = [&](const std::string& floor) {
    return put(
        "m.json",
        R"({"relume": 1, "ids": "cryptoobject", "materials": {")" + floor +
            R"(": {"diffuse": "lambert", "specular": "none", "albedo": 0}, "default": {"diffuse": "lambert", "specular": "none", "albedo": 1}}})");
  };
  const Found floor(blender, {"Floor"});
  const std::vector<std::uint32_t> most = floor.objects.most_covering(floor.gbuffer);
  for (const char* called : {"Floor", "0x6a2fb16e"}) {
    const Channels image = shade(blender, R"({"type": "ambient", "intensity": 1})", {"--materials", materials(called)});
    for (std::size_t i = 0; i < most.size(); ++i) EXPECT_EQ(image.at("R")[i] > 0, floor.shows_surface(i) && !floor.ids.contains(most[i])) << i;
  }
  const ProgramRun unknown = run(blender, sun + "}", {"--materials", materials("Flor")});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_EQ(unknown.err, "relume: " + in("m.json") +
                             ": Cryptomatte \"ViewLayer.CryptoObject\" has no object \"Flor\" (near: \"Floor\"; relume inspect lists them)\n");
  const std::string twice = put("twice.json", R"({"relume": 1, "materials": {"Floor": {}, "0x6a2fb16e": {}, "default": {}}})");
  EXPECT_NE(run(blender, sun + "}", {"--materials", twice}).err.find("\"Floor\" is the same object as another entry"), std::string::npos);
  const std::string lacking = put("lacking.json", R"({"relume": 1, "materials": {"Floor": {}}})");
  EXPECT_NE(run(blender, sun + "}", {"--materials", lacking}).err.find(": no material for object "), std::string::npos);
}

TEST_F(Links, RefusalsNameTheLight) {
  const std::string file = plain_file();
  EXPECT_EQ(run(blender, sun + ", \"include\": [\"Flor\"]}").err,
            "relume: light \"sun\": Cryptomatte \"ViewLayer.CryptoObject\" has no object \"Flor\" (near: \"Floor\"; relume inspect lists them)\n");
  EXPECT_EQ(run(file, sun + ", \"include\": [\"torus\"]}").err,
            "relume: " + file + ": no Cryptomatte to find objects in by name (\"ids\" in a material file or rig names one; --map ids=LAYER too)\n");
  EXPECT_EQ(run(file, sun + ", \"include\": [\"torus\"]}", {}, "id").err,
            "relume: light \"sun\": \"torus\" is a name, but layer \"id\" holds numbers (0..4294967295; a Cryptomatte in \"ids\" holds names)\n");
  EXPECT_EQ(run(blender, sun + ", \"include\": [3]}", {}, "IndexOB").code, 2);
  const std::string materials = put("m.json", R"({"relume": 1, "ids": "id", "materials": {"1": {}, "default": {}}})");
  EXPECT_EQ(run(file, sun + ", \"include\": [1]}", {"--materials", materials}, "albedo.R").err,
            "relume: light \"sun\": takes ids from layer \"albedo.R\" where others take them from \"id\" (one layer of numbers is read at a time; a "
            "Cryptomatte may stand beside it)\n");
}

}  // namespace
}  // namespace relume
