// Environment lights through the program: one texel is a directional light, an even map ambient light, samples converge to the exact sum.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>

#include "tests/channels.h"
#include "tests/made_up_exr.h"
#include "tests/make_gbuffer.h"
#include "tests/psnr.h"
#include "tests/run_program.h"

namespace relume {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int width = 32, height = 16;

using Sky = std::function<double(const std::string& channel, int x, int y)>;

class Environment : public testing::Test {
 protected:
  /// The sphere over the floor, with an image of these texels beside it.
  explicit Environment(int side = 48) {
    MadeUpGBuffer made = MadeUpGBuffer::of_size(side, side);
    made.with({"albedo.R", "albedo.G", "albedo.B", "roughness", "metallic", "id"});
    write_gbuffer(folder_ / "in.exr", made);
  }
  void put_sky(const Sky& sky, int scale = 1) const {
    const MadeUpExr image({{"", "", {"R", "G", "B"}}}, width * scale, height * scale, sky);
    std::filesystem::copy_file(image.file, folder_ / "sky.exr", std::filesystem::copy_options::overwrite_existing);
  }
  ProgramRun run(const std::string& lights, std::vector<std::string> options = {}) const {
    std::ofstream(folder_ / "rig.json") << "{\"relume\": 1, \"lights\": [" + lights + "]}";
    options.insert(options.begin(), {"shade", (folder_ / "in.exr").string(), "-l", (folder_ / "rig.json").string(), "-o",
                                     (folder_ / "out.exr").string(), "--overwrite"});
    if (std::find(options.begin(), options.end(), "--device") == options.end()) options.insert(options.end(), {"--device", "twin"});
    return run_program(options);
  }
  Channels shade(const std::string& lights, const std::vector<std::string>& options = {}) const {
    const ProgramRun result = run(lights, options);
    EXPECT_EQ(result.code, 0) << result.err;
    return result.code == 0 ? read_channels(folder_ / "out.exr") : Channels{};
  }

  TemporaryFolder folder_;
};

/// "type": "environment" with the rest of its keys.
std::string sky(const std::string& keys = {}) {
  return R"({"type": "environment", "name": "sky", "texture": "sky.exr", "intensity": 1)" + (keys.empty() ? "" : ", " + keys) + "}";
}

std::string directional(double x, double y, double z, double irradiance) {
  char text[256];
  std::snprintf(text, sizeof text, R"({"type": "directional", "direction": [%.17g, %.17g, %.17g], "intensity": %.17g})", x, y, z, irradiance);
  return text;
}

/// Largest difference, relative to the brightest value of `b`.
double difference(const Channels& a, const Channels& b) {
  double largest = 0, brightest = 0;
  for (const std::string c : {"R", "G", "B"})
    for (std::size_t i = 0; i < b.at(c).size(); ++i) {
      largest = std::max(largest, std::fabs(double(a.at(c)[i]) - b.at(c)[i]));
      brightest = std::max(brightest, double(b.at(c)[i]));
    }
  EXPECT_GT(brightest, 0);
  return largest / brightest;
}

double decibels(const Channels& image, const Channels& reference) {
  return psnr(rgb_of(image), rgb_of(reference), std::vector<bool>(reference.at("R").size(), true));
}

/// The direction of Mitsuba's texel 20, 5, where light comes from, and its solid angle: interior rows weigh 2 sin(theta) (1 - cos(step))/step.
struct LitTexel {
  double step = pi / (height - 1), theta = pi * 5 / (height - 1), phi = 2 * pi * 20.5 / width;
  double x = std::sin(phi) * std::sin(theta), y = std::cos(theta), z = -std::cos(phi) * std::sin(theta);
  double solid_angle = 2 * pi / width * 2 * std::sin(theta) * (1 - std::cos(step)) / step;
};

double one_texel(const std::string&, int x, int y) { return x == 20 && y == 5 ? 40 : 0; }

TEST_F(Environment, OneTexelIsADirectionalLight) {
  put_sky(one_texel);
  const LitTexel texel;
  const Channels expected = shade(directional(-texel.x, -texel.y, -texel.z, 40 * texel.solid_angle));
  for (const char* method : {"exact", "median_cut"})
    EXPECT_LE(difference(shade(sky(R"("mapping": "mitsuba")"), {"--environment", method}), expected), 2e-6) << method;
}

TEST_F(Environment, TurnsAsARightHandDoes) {
  put_sky(one_texel);
  const LitTexel texel;  // a quarter turn about y takes (x, y, z) to (z, y, -x)
  const Channels expected = shade(directional(-texel.z, -texel.y, texel.x, 40 * texel.solid_angle));
  const std::vector<std::string> exact{"--environment", "exact"};
  EXPECT_LE(difference(shade(sky(R"("mapping": "mitsuba", "rotation": 90)"), exact), expected), 2e-6);
  EXPECT_LE(difference(shade(sky(R"("mapping": "mitsuba", "world_from_light": [0,0,1, 0,1,0, -1,0,0])"), exact), expected), 2e-6);
  EXPECT_LE(difference(shade(sky(R"("mapping": "mitsuba", "rotation": -1350)"), exact), expected), 2e-6);
}

double mean(const Channels& image) {
  double sum = 0;
  for (const std::string c : {"R", "G", "B"}) sum = std::accumulate(image.at(c).begin(), image.at(c).end(), sum);
  return sum / double(3 * image.at("R").size());
}

TEST_F(Environment, AnEvenMapIsAmbientLight) {
  put_sky([](const std::string& c, int, int) { return c == "G" ? 0.7 : 0.4; }, 4);
  const std::string ambient = R"({"type": "ambient", "intensity": [0.4, 0.7, 0.4]})";
  const Channels lambert = shade(ambient, {"--specular", "none"}), both = shade(ambient);
  EXPECT_LE(difference(shade(sky(), {"--environment", "exact", "--specular", "none"}), lambert), 3e-3);
  EXPECT_GE(decibels(shade(sky(), {"--environment", "exact"}), both), 45);
  const Channels sampled = shade(sky(), {"--environment", "sampled", "--samples", "512"});
  EXPECT_GE(decibels(sampled, both), 45);
  EXPECT_NEAR(mean(sampled) / mean(both), 1, 3e-3);  // pixels' errors cancel
  EXPECT_GE(decibels(shade(sky(), {"--environment", "prefiltered"}), both), 45);
  // White furnace: what is white is not seen before it.
  const std::vector<std::string> furnace{"--environment", "exact", "--specular", "none", "--set", "albedo=1"};
  put_sky([](const std::string&, int, int) { return 1; }, 4);
  const Channels white = shade(sky(), furnace), gbuffer = read_channels(folder_ / "in.exr");
  for (std::size_t i = 0; i < white.at("R").size(); ++i) EXPECT_NEAR(white.at("R")[i], gbuffer.at("id")[i] > 0, 3e-3);
}

/// A sky of harmonics of the degrees 0 to 2, all nine in one channel or another; the others than 0 are multiplied by a share.
double harmonic_sky(const std::string& channel, const glm::dvec3& d, double first = 1, double second = 1) {
  if (channel == "R") return 1 + first * 0.5 * (d.x + d.y + d.z);
  if (channel == "G") return 1 + second * 0.5 * (d.x * d.y + d.y * d.z + d.z * d.x + d.x * d.x - d.y * d.y);
  return 1 + second * (3 * d.z * d.z - 1);
}

/// Its texels as Mitsuba maps them.
double harmonic_texel(const std::string& channel, int x, int y) {
  const double theta = pi * y / (8 * height - 1), phi = 2 * pi * (x + 0.5) / (8 * width);
  return harmonic_sky(channel, {std::sin(phi) * std::sin(theta), std::cos(theta), -std::cos(phi) * std::sin(theta)});
}

void expect_pixels(const Channels& image, double error, const std::function<double(const std::string& channel, const ScenePixel&)>& expected) {
  const MadeUpGBuffer made = MadeUpGBuffer::of_size(48, 48);
  for (const std::string c : {"R", "G", "B"})
    for (int i = 0; i < 48 * 48; ++i) {
      const ScenePixel pixel = scene_at(made, i % 48, i / 48);
      if (pixel.id == 0) continue;
      ASSERT_NEAR(image.at(c)[std::size_t(i)], expected(c, pixel), error) << c << " " << i;
    }
}

// Ramamoorthi and Hanrahan 2001: irradiance keeps 2/3 of the first degree and 1/4 of the second.
TEST_F(Environment, PrefilteredLightOfNineHarmonicsIsTheirIrradiance) {
  put_sky(harmonic_texel, 8);
  const Channels image = shade(sky(R"("mapping": "mitsuba")"), {"--environment", "prefiltered", "--specular", "none", "--set", "albedo=1"});
  expect_pixels(image, 1e-3, [](const std::string& c, const ScenePixel& pixel) { return harmonic_sky(c, pixel.normal, 2.0 / 3, 0.25); });
}

TEST_F(Environment, APrefilteredMirrorShowsTheSky) {
  put_sky(harmonic_texel, 8);
  const Channels image = shade(sky(R"("mapping": "mitsuba")"), {"--environment", "prefiltered", "--diffuse", "none", "--specular", "ggx", "--set",
                                                                "alpha=0.0001", "--set", "f0=1", "--set", "albedo=1"});
  expect_pixels(image, 1e-2, [](const std::string& c, const ScenePixel& pixel) {
    const glm::dvec3 n = pixel.normal, v = glm::normalize(glm::dvec3(0, 0, scene_eye_z) - pixel.position);
    return harmonic_sky(c, 2 * glm::dot(n, v) * n - v);
  });
}

/// A sun in a sky over a dark ground.
double outdoors(const std::string& channel, int x, int y) {
  if (x == 25 && y == 4) return channel == "B" ? 150 : 200;
  if (y >= height / 2) return 0.1;
  return channel == "B" ? 1 + 0.3 * std::sin(0.4 * x) : 0.6;
}

TEST_F(Environment, SamplesConvergeToTheExactSumAndSayHowFarTheyAre) {
  put_sky(outdoors);
  const Channels exact = shade(sky(), {"--environment", "exact", "--set", "roughness=0.6"});
  double before = 0;
  for (const int samples : {16, 64, 1024}) {
    const ProgramRun result = run(sky(), {"--samples", std::to_string(samples), "--set", "roughness=0.6"});
    ASSERT_EQ(result.code, 0) << result.err;
    const double db = decibels(read_channels(folder_ / "out.exr"), exact);
    const auto at = result.err.find("estimated error ");
    ASSERT_NE(at, std::string::npos) << result.err;
    const double estimated = std::stod(result.err.substr(at + 16));
    std::printf("%d samples: %.1f dB from the exact sum, estimated %.1f dB\n", samples, db, estimated);
    EXPECT_GT(db, before + 3);
    if (samples < 1024) {  // after that the exact sum's texels, each a single direction, are what is left
      EXPECT_NEAR(estimated, db - 4, 5);
    }
    before = db;
  }
  EXPECT_GE(before, 45);
}

TEST_F(Environment, BandsAndCropsShowTheSamePicture) {
  put_sky(outdoors);
  const Channels whole = shade(sky());
  EXPECT_EQ(difference(shade(sky(), {"--memory", "200K"}), whole), 0);
  const Channels crop = shade(sky(), {"--crop", "10,20,40,45"});
  for (int y = 0; y < 25; ++y)
    for (int x = 0; x < 30; ++x) ASSERT_EQ(crop.at("G")[std::size_t(y * 30 + x)], whole.at("G")[std::size_t((y + 20) * 48 + x + 10)]);
}

TEST_F(Environment, IsOneLightByName) {
  put_sky(outdoors);
  const std::string lamp = R"({"type": "point", "name": "lamp", "position": [2,3,4], "intensity": 20})";
  for (const char* method : {"exact", "median_cut", "sampled"}) {
    const Channels image = shade(sky() + ", " + lamp, {"--environment", method, "--layers", "lights,diffuse,specular"});
    EXPECT_EQ(std::count_if(image.begin(), image.end(), [](const auto& c) { return c.first.starts_with("light."); }), 6) << method;
    for (std::size_t i = 0; i < image.at("R").size(); ++i) {
      const double total = image.at("R")[i], parts = double(image.at("light.sky.R")[i]) + image.at("light.lamp.R")[i];
      ASSERT_NEAR(parts, total, 1e-4 * total + 1e-6) << method;
      ASSERT_NEAR(double(image.at("diffuse.R")[i]) + image.at("specular.R")[i], total, 1e-5 * total + 1e-6) << method;
    }
  }
}

TEST_F(Environment, ShinesOnItsObjectsAlone) {
  put_sky(outdoors);
  const Channels ids = read_channels(folder_ / "in.exr");
  for (const char* method : {"exact", "median_cut", "sampled"}) {
    const Channels all = shade(sky(), {"--environment", method});
    for (const bool include : {true, false}) {
      const Channels image = shade(sky(include ? R"("include": [1])" : R"("exclude": [1])"), {"--environment", method, "--map", "ids=id"});
      for (std::size_t i = 0; i < image.at("R").size(); ++i)
        ASSERT_EQ(image.at("R")[i], (ids.at("id")[i] == 1) == include ? all.at("R")[i] : 0) << method;
    }
  }
}

TEST_F(Environment, SeveralAddUp) {
  put_sky(outdoors);
  for (const char* method : {"exact", "sampled"}) {
    const Channels once = shade(sky(), {"--environment", method});
    EXPECT_LE(difference(shade(sky(R"("exposure": -1)") + "," + sky(R"("exposure": -1)"), {"--environment", method}), once), 1e-4) << method;
  }
}

TEST_F(Environment, CountsForAmbientFractions) {
  put_sky(outdoors);
  const std::string share = R"({"type": "ambient", "fraction": 0.1})";
  const Channels exact = shade(sky() + ", " + share, {"--environment", "exact", "--layers", "ambient"}),
                 sampled = shade(sky() + ", " + share, {"--samples", "256", "--layers", "ambient"});
  const std::size_t middle = 24 * 48 + 24;
  EXPECT_GT(exact.at("ambient.R")[middle], 0);
  EXPECT_NEAR(sampled.at("ambient.R")[middle], exact.at("ambient.R")[middle], 0.01 * exact.at("ambient.R")[middle]);
}

TEST_F(Environment, RefusesInOneLine) {
  const auto refusal = [&](const std::string& lights, const std::vector<std::string>& options = {}) {
    const ProgramRun result = run(lights, options);
    EXPECT_EQ(result.code, 2) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out.exr"));
    return result.err;
  };
  const auto has = [](const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; };
  EXPECT_TRUE(has(refusal(sky()), "sky.exr: "));  // not there
  put_sky([](const std::string&, int x, int) { return x == 3 ? std::nan("") : 1; });
  EXPECT_TRUE(has(refusal(sky()), "sky.exr: the radiance of texel 3, 0 is NaN"));
  put_sky(outdoors);
  EXPECT_TRUE(has(refusal(sky(R"("rotation": 1, "world_from_light": [1,0,0,0,1,0,0,0,1])")), "\"rotation\": stands instead of"));
  EXPECT_TRUE(has(refusal(sky(R"("world_from_light": [1,0,0,0,2,0,0,0,1])")), "must be a rotation"));
  EXPECT_TRUE(has(refusal(sky(R"("mapping": "maya")")), "\"mapping\": must be one of openexr, usdlux, mitsuba"));
  EXPECT_TRUE(has(refusal(R"({"type": "environment", "intensity": 1})"), "\"texture\" is missing"));
  EXPECT_TRUE(has(refusal(R"({"type": "environment", "texture": "", "intensity": 1})"), "\"texture\": must name a file"));
  EXPECT_TRUE(has(refusal(R"({"type": "environment", "texture": "sky.exr", "intensity": [1,-1,1]})"), "must not be negative"));
  EXPECT_TRUE(has(refusal(R"({"type": "environment", "texture": "sky.txt", "intensity": 1})"), "sky.txt"));
  std::ofstream(folder_ / "sky.exr");  // empty
  EXPECT_TRUE(has(refusal(sky()), "sky.exr: "));
}

TEST_F(Environment, BlackIsNoLight) {
  put_sky([](const std::string&, int, int) { return 0; });
  const ProgramRun result = run(sky());
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.err.find("environment \"sky\": black everywhere"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace relume
