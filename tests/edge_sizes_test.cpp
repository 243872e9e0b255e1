// Sizes and contents at the edge, through the program: the right picture or one clear line, and nothing left in the folder but the output.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "gbuffer/exr_file.h"
#include "tests/channels.h"
#include "tests/make_gbuffer.h"
#include "tests/run_program.h"

namespace relume {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

const char* const one_light = R"({"relume": 1, "lights": [{"type": "point", "position": [2, 3, 4], "intensity": [40, 38, 35]}]})";
const char* const no_lights = R"({"relume": 1, "lights": []})";

/// Shades a made-up G-buffer in a folder of its own.
class EdgeCase {
 public:
  explicit EdgeCase(const MadeUpGBuffer& made, const std::string& rig = one_light) {
    write_gbuffer(input_.path() / "in.exr", made);
    std::ofstream(input_ / "rig.json") << rig;
  }

  ProgramRun shade(const std::string& output, std::vector<std::string> options = {}, const std::string& device = "twin") const {
    std::vector<std::string> arguments{"shade", (input_ / "in.exr").string(), "--lights", (input_ / "rig.json").string(),
                                       "-o",    (output_ / output).string(),  "--json",   "--device",
                                       device};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_program(arguments);
  }

  /// The channels of what must have been written without an error.
  Channels channels(const std::string& output, const std::vector<std::string>& options = {}, const std::string& device = "twin") const {
    const ProgramRun run = shade(output, options, device);
    EXPECT_EQ(run.code, 0) << run.err;
    return run.code == 0 ? read_channels(output_ / output) : Channels{};
  }

  std::filesystem::path output(const std::string& name) const { return output_ / name; }
  std::set<std::string> outputs() const {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(output_.path())) names.insert(entry.path().filename());
    return names;
  }

 private:
  TemporaryFolder input_, output_;
};

std::size_t lit_pixels(const Channels& channels) {
  const std::vector<float>& green = channels.at("G");
  return std::size_t(std::count_if(green.begin(), green.end(), [](float v) { return v > 0; }));
}

bool all_finite(const Channels& channels) {
  for (const auto& [name, values] : channels)
    if (!std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); })) return false;
  return true;
}

bool black(const Channels& channels) {
  for (const char* name : {"R", "G", "B"})
    if (std::any_of(channels.at(name).begin(), channels.at(name).end(), [](float v) { return v != 0; })) return false;
  return true;
}

TEST(EdgeSizes, OnePixel) {
  const EdgeCase test(MadeUpGBuffer::of_size(1, 1));
  const Channels image = test.channels("out.exr");
  ASSERT_FALSE(image.empty());
  // The one ray meets the sphere at (0, 0, 1): lit from (2, 3, 4); no roughness layer, so diffuse light alone, with the default albedo.
  const double d2 = 22, n_l = 3 / std::sqrt(d2), expected = 38 / d2 * n_l * 0.8 / M_PI;
  EXPECT_NEAR(image.at("G")[0], expected, 1e-5 * expected);
  EXPECT_EQ(image.at("A")[0], 1);
  EXPECT_EQ(test.outputs(), std::set<std::string>{"out.exr"});
}

TEST(EdgeSizes, OneColumnAndOneRow) {
  for (const bool tall : {true, false}) {
    const EdgeCase test(MadeUpGBuffer::of_size(tall ? 1 : 100000, tall ? 100000 : 1));
    const Channels image = test.channels("out.exr");
    ASSERT_FALSE(image.empty());
    EXPECT_EQ(image.at("G").size(), 100000u);
    EXPECT_TRUE(all_finite(image));
    // The sphere's diameter is 0.56 of the 40 degrees; the light reaches part of it.
    EXPECT_GT(lit_pixels(image), 25000u);
    EXPECT_LT(lit_pixels(image), 100000u);
    EXPECT_EQ(test.outputs(), std::set<std::string>{"out.exr"});
  }
}

/// In bands within the memory given: the whole frame at once would take `whole` bytes.
void shade_large(int side, const std::string& memory, double most_seconds) {
  MadeUpGBuffer made = MadeUpGBuffer::of_size(side, side);
  made.half = true;
  made.floor = false;
  const auto begin = std::chrono::steady_clock::now();
  const EdgeCase test(made);
  const auto written = std::chrono::steady_clock::now();
  const ProgramRun run = test.shade("out.exr", {"--memory", memory, "--half"});
  const auto end = std::chrono::steady_clock::now();
  ASSERT_EQ(run.code, 0) << run.err;
  rusage used{};
  getrusage(RUSAGE_CHILDREN, &used);  // the largest child so far: a bound on this one
  const double seconds = std::chrono::duration<double>(end - written).count();
  std::printf("%d x %d in %s: made in %.1f s, shaded in %.1f s, at most %ld MB resident\n", side, side, memory.c_str(),
              std::chrono::duration<double>(written - begin).count(), seconds, used.ru_maxrss / 1024);
  EXPECT_LT(used.ru_maxrss, 2L << 20);  // kilobytes
  EXPECT_LT(seconds, most_seconds);
  EXPECT_EQ(test.outputs(), std::set<std::string>{"out.exr"});
  const ExrFile file(test.output("out.exr"));
  const int middle = side / 2;
  float lit = 0, background = 1;
  const Destination centre{"G", SampleType::float32, &lit, 4, 4}, corner{"G", SampleType::float32, &background, 4, 4};
  file.read(0, {middle, middle, middle + 1, middle + 1}, {&centre, 1});
  file.read(0, {side - 1, side - 1, side, side}, {&corner, 1});
  EXPECT_GT(lit, 0.1f);
  EXPECT_EQ(background, 0);
}

TEST(EdgeSizes, FourThousandSquareInBands) { shade_large(4096, "64M", 60); }

TEST(EdgeSizes, SixteenThousandSquareInBands) {
  if (!std::getenv("RELUME_LONG")) GTEST_SKIP() << "RELUME_LONG=1 runs it: it takes minutes";
  shade_large(16384, "512M", 600);
}

TEST(EdgeSizes, HundredThousandLights) {
  std::string rig = R"({"relume": 1, "lights": [)";
  for (int k = 0; k < 100000; ++k) {
    const double angle = 0.001 * k, height = 2 + 1e-5 * k;
    char light[200];
    std::snprintf(light, sizeof light, R"(%s{"type": "point", "position": [%.6f, %.6f, %.6f], "intensity": [0.001, 0.001, 0.001]%s})", k ? "," : "",
                  4 * std::cos(angle), height, 4 * std::sin(angle), k % 2 ? R"(, "range": 9)" : "");
    rig += light;
  }
  MadeUpGBuffer made = MadeUpGBuffer::of_size(24, 24);
  const EdgeCase test(made, rig + "]}");
  const Channels image = test.channels("out.exr");
  ASSERT_FALSE(image.empty());
  EXPECT_TRUE(all_finite(image));
  EXPECT_GT(lit_pixels(image), 100u);
  // One pixel in double precision, diffuse alone.
  const Channels diffuse = test.channels("diffuse.exr", {"--specular", "none"});
  const ScenePixel pixel = scene_at(made, 12, 8);
  double expected = 0;
  for (int k = 0; k < 100000; ++k) {
    const double angle = 0.001 * k;
    const glm::dvec3 to_light = glm::dvec3(4 * std::cos(angle), 2 + 1e-5 * k, 4 * std::sin(angle)) - pixel.position;
    const double d = glm::length(to_light), window = k % 2 ? std::clamp(1 - std::pow(d / 9, 4), 0.0, 1.0) : 1;
    expected += 0.001 / (d * d) * window * std::max(0.0, glm::dot(pixel.normal, to_light) / d) * 0.8 / M_PI;
  }
  EXPECT_NEAR(diffuse.at("G")[8 * 24 + 12], expected, 1e-4 * expected);  // a hundred thousand roundings
  EXPECT_EQ(test.outputs(), (std::set<std::string>{"out.exr", "diffuse.exr"}));
}

TEST(EdgeSizes, NoLights) {
  MadeUpGBuffer made;
  made.with({"A"});
  made.pixel = [](int x, int, ScenePixel& pixel) { pixel.alpha = x / 64.0; };
  const EdgeCase test(made, no_lights);
  const Channels image = test.channels("out.exr");
  ASSERT_FALSE(image.empty());
  EXPECT_TRUE(black(image));
  for (int i = 0; i < 64 * 64; ++i) ASSERT_EQ(image.at("A")[std::size_t(i)], float(i % 64) / 64);
}

TEST(EdgeSizes, NoPositions) {
  MadeUpGBuffer made;
  made.pixel = [](int, int, ScenePixel& pixel) { pixel.position = glm::dvec3(nan); };
  const EdgeCase test(made);
  const ProgramRun run = test.shade("out.exr");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("\"bad_pixels\": 4096"), std::string::npos) << run.out;
  const Channels image = read_channels(test.output("out.exr"));
  EXPECT_TRUE(black(image));
  EXPECT_TRUE(all_finite(image));
  made.camera_in_header = false;
  const EdgeCase blind(made);
  const ProgramRun refused = blind.shade("out.exr");
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find(": no camera: "), std::string::npos) << refused.err;
  EXPECT_TRUE(blind.outputs().empty());
}

TEST(EdgeSizes, NoNormals) {
  for (const double value : {double(nan), 0.0}) {  // NaN everywhere, and background everywhere
    MadeUpGBuffer made;
    made.pixel = [value](int, int, ScenePixel& pixel) { pixel.normal = glm::dvec3(value); };
    const EdgeCase test(made);
    const ProgramRun run = test.shade("out.exr");
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_NE(run.out.find("\"surface_pixels\": 0"), std::string::npos) << run.out;
    EXPECT_NE(run.out.find(value == 0 ? "\"bad_pixels\": 0" : "\"bad_pixels\": 4096"), std::string::npos) << run.out;
    const Channels image = read_channels(test.output("out.exr"));
    EXPECT_TRUE(black(image));
    EXPECT_TRUE(all_finite(image));
  }
}

/// A pixel in eight is hostile; its neighbours must not notice, and nothing that is not finite is written.
TEST(EdgeSizes, HostileValues) {
  MadeUpGBuffer made;
  made.with({"albedo.R", "albedo.G", "albedo.B", "roughness", "metallic", "A"});
  const EdgeCase clean(made);
  made.pixel = [](int x, int y, ScenePixel& pixel) {
    const float values[] = {nan, std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(), 1e38f, -1e38f, 1e-44f, -1.0f};
    if ((x + 8 * y) % 8) return;
    const float bad = values[(x / 8 + y) % 7];
    switch (y % 6) {
      case 0:
        pixel.position[x / 8 % 3] = bad;
        break;
      case 1:
        pixel.normal[x / 8 % 3] = bad;
        break;
      case 2:
        pixel.albedo[x / 8 % 3] = bad;
        break;
      case 3:
        pixel.roughness = bad;
        break;
      case 4:
        pixel.metallic = bad;
        break;
      default:
        pixel.alpha = bad;
        break;
    }
  };
  const EdgeCase hostile(made);
  for (const char* rig :
       {one_light, R"({"relume": 1, "lights": [{"type": "ambient", "intensity": [1, 1, 1]}, {"type": "ambient", "fraction": 0.1}]})"}) {
    const EdgeCase test(made, rig);
    EXPECT_TRUE(all_finite(test.channels("out.exr", {"--layers", "diffuse,specular,ambient"}))) << rig;
  }
  const Channels a = clean.channels("out.exr"), b = hostile.channels("out.exr");
  ASSERT_FALSE(a.empty() || b.empty());
  for (std::size_t i = 0; i < 64 * 64; ++i) {
    if (i % 8 == 0) continue;
    ASSERT_EQ(a.at("G")[i], b.at("G")[i]) << i;
  }
}

TEST(EdgeSizes, BandsAndCropsChangeNoBit) {
  MadeUpGBuffer made;
  made.data = {-30, -17, 71, 60};
  made.display = {0, 0, 64, 48};
  made.with({"albedo.R", "albedo.G", "albedo.B", "roughness", "metallic", "A"});
  const EdgeCase test(made, R"({"relume": 1, "lights": [{"type": "point", "position": [2, 3, 4], "intensity": [40, 38, 35]},
      {"type": "directional", "direction": [1, -1, -1], "intensity": [1, 1, 2]}, {"type": "ambient", "fraction": 0.3}]})");
  const std::vector<std::string> layers{"--layers", "diffuse,specular,ambient,lights"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.end(), layers.begin(), layers.end());
    return more;
  };
  const Channels whole = test.channels("whole.exr", layers), bands = test.channels("bands.exr", with({"--memory", "100K"}));
  ASSERT_FALSE(whole.empty() || bands.empty());
  EXPECT_GT(lit_pixels(whole), 1000u);
  EXPECT_EQ(whole, bands);
  EXPECT_GE(nlohmann::json::parse(test.shade("again.exr", with({"--memory", "100K"})).out)["bands"], 5);
  const ExrFile file(test.output("whole.exr"));
  EXPECT_EQ(file.parts()[0].data_window, made.data);
  EXPECT_EQ(file.parts()[0].display_window, made.display);

  const Window crop{-5, 3, 40, 31};
  const Channels cropped = test.channels("crop.exr", with({"--crop", "-5,3,40,31"}));
  const ExrFile cropped_file(test.output("crop.exr"));
  EXPECT_EQ(cropped_file.parts()[0].data_window, crop);
  EXPECT_EQ(cropped_file.parts()[0].display_window, made.display);
  for (const auto& [name, values] : whole)
    for (int y = crop.min_y; y < crop.max_y; ++y)
      for (int x = crop.min_x; x < crop.max_x; ++x)
        ASSERT_EQ(cropped.at(name)[std::size_t((y - crop.min_y) * crop.width() + x - crop.min_x)],
                  values[std::size_t((y - made.data.min_y) * made.data.width() + x - made.data.min_x)])
            << name << " at " << x << ", " << y;
}

}  // namespace
}  // namespace relume
