// Small pictures kept: made-up scenes, shaded on the best device, against what the twin made of them when they were looked at (tests/data/golden).
// RELUME_GOLDEN_WRITE=FOLDER remakes them and leaves a PNG of each in FOLDER to look at.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "tests/channels.h"
#include "tests/make_gbuffer.h"
#include "tests/run_program.h"

namespace relume {
namespace {

/// A key light from the upper right front, a warm cone on the floor from the left, a faint sky-blue sun from behind.
const char* const three_lights = R"({"relume": 1, "lights": [
    {"type": "point", "position": [2, 3, 4], "intensity": [40, 38, 35]},
    {"type": "spot", "position": [-3, 3, 1], "direction": [2, -4, 0], "intensity": [60, 30, 10], "inner_angle": 12, "outer_angle": 20},
    {"type": "directional", "direction": [1, -0.4, 1], "intensity": [0.6, 0.9, 1.6]}]})";
const char* const one_light = R"({"relume": 1, "lights": [{"type": "point", "position": [2, 3, 4], "intensity": [40, 40, 40]}]})";
const char* const light_and_ambient = R"({"relume": 1, "lights": [
    {"type": "point", "position": [-3, 2, 4], "intensity": [45, 45, 40]}, {"type": "ambient", "intensity": [0.1, 0.12, 0.16]}]})";

struct Golden {
  const char* name;
  const char* rig;
  std::vector<std::string> options;
  const char* to_see;  ///< in the picture, so that whoever remakes it can tell right from wrong
};

const Golden goldens[] = {
    {"metal_rough",
     three_lights,
     {},
     "a brown ball over a checked floor; up and right of its middle a round golden highlight, cut off at the seam to the left half, which is no "
     "metal; at "
     "the left edge an orange patch of the spot's light under a white-blue glint of the sun; a pool of warm light on the floor, lower left"},
    {"phong",
     one_light,
     {"--specular", "phong", "--set", "ks=0.5", "--set", "exponent=40"},
     "the same ball, no seam, one round white highlight up and right of the middle; black at the lower left edge; the floor darkens to the left and "
     "back"},
    {"plastic",
     one_light,
     {"--diffuse", "plastic", "--specular", "beckmann", "--set", "ior=1.5", "--set", "alpha=0.1"},
     "as phong, with a highlight a third as wide and not as white, and a body that is a little dimmer, most of all towards its edges"},
    {"principled",
     light_and_ambient,
     {"--diffuse", "principled", "--specular", "principled", "--set", "clearcoat=1", "--set", "sheen=0.5"},
     "lit from the left: the left half pale brown with one small pale highlight, and a sharp seam to the metal half, evenly dark brown under the "
     "ambient "
     "light; no black on the ball"}};

MadeUpGBuffer scene() {
  MadeUpGBuffer made = MadeUpGBuffer::of_size(48, 48);
  made.with({"albedo.R", "albedo.G", "albedo.B", "roughness", "metallic", "A"});
  return made;
}

class GoldenImage : public testing::TestWithParam<Golden> {};

/// As OpenImageIO's compare does: a share of the values may be off by more than a soft bound, none by more than a hard one; both relative to the
/// value expected, dark ones to a hundredth of the brightest. The bounds let a GPU's inexact division through (host/self_test.h).
void expect_close(const Channels& image, const Channels& expected, const std::string& to_see) {
  constexpr double soft = 1e-4, hard = 5e-3, percent = 1;
  ASSERT_EQ(image.size(), expected.size());
  double brightest = 0, worst = 0;
  for (const auto& [name, values] : expected) brightest = std::max(brightest, double(*std::max_element(values.begin(), values.end())));
  std::size_t beyond = 0, all = 0;
  for (const auto& [name, values] : expected) {
    ASSERT_EQ(image.at(name).size(), values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double error = std::fabs(double(image.at(name)[i]) - values[i]) / std::max(std::fabs(double(values[i])), 0.01 * brightest);
      worst = std::isfinite(error) ? std::max(worst, error) : INFINITY;
      beyond += !(error <= soft);
      ++all;
    }
  }
  EXPECT_LE(worst, hard) << "to see: " << to_see;
  EXPECT_LE(100.0 * double(beyond) / double(all), percent) << "to see: " << to_see;
}

TEST_P(GoldenImage, IsAsItWas) {
  const Golden& golden = GetParam();
  const TemporaryFolder folder;
  write_gbuffer(folder / "in.exr", scene());
  const std::filesystem::path kept = std::filesystem::path(RELUME_SOURCE) / "tests/data/golden" / (std::string(golden.name) + ".exr");
  std::vector<std::string> arguments{"shade", (folder / "in.exr").string(), "--lights", "-", "--quiet"};
  arguments.insert(arguments.end(), golden.options.begin(), golden.options.end());
  const auto shade_to = [&](const std::filesystem::path& output, const std::vector<std::string>& more) {
    std::vector<std::string> all = arguments;
    all.insert(all.end(), {"-o", output.string()});
    all.insert(all.end(), more.begin(), more.end());
    const ProgramRun run = run_program(all, golden.rig);
    ASSERT_EQ(run.code, 0) << run.err;
  };
  if (const char* pictures = std::getenv("RELUME_GOLDEN_WRITE"))
    shade_to(kept, {"--device", "twin", "--overwrite", "--png", (std::filesystem::path(pictures) / (std::string(golden.name) + ".png")).string()});
  shade_to(folder / "out.exr", {});
  expect_close(read_channels(folder / "out.exr"), read_channels(kept), golden.to_see);
}

INSTANTIATE_TEST_SUITE_P(Scenes, GoldenImage, testing::ValuesIn(goldens), [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace relume
