// The light tree: no channel of any pixel is further from brute force than what is asked of it, whatever the lights and lobes; and the lights that
// are met grow far slower than the lights.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <numeric>
#include <ostream>
#include <random>

#include "host/light_cuts.h"
#include "host/light_lists.h"
#include "host/twin.h"
#include "tests/channels.h"
#include "tests/make_gbuffer.h"
#include "tests/run_program.h"
#include "tests/unranged_lights.h"

namespace relume {
namespace {

struct Outcome {
  double worst = 0;  ///< of any channel of any pixel, as a share of it
  double met = 0;    ///< records that a pixel meets in the mean
  double lit = 0;    ///< channels of pixels that are lit at all
};

/// `brute`: of the same scene.
Outcome cut_and_compare(UnrangedScene& scene, const std::vector<float>& brute, double error) {
  std::vector<LightRecord> records = scene.lights;
  const LightTree tree(records, scene.begin);
  const LightCuts cuts(tree, scene.programs, scene.tables, error);
  LightLists lists;
  Frame frame = scene.frame;
  FrameBounds bounds(scene.planes, frame, width);
  frame.lists = lists.add(bounds, {scene.lights, scene.begin, tree}, cuts, std::size_t(1) << 28);
  EXPECT_GT(frame.lists, 0);
  std::swap(scene.lights, records);
  const std::vector<float> cut = shaded(scene, frame, lists.numbers());
  std::swap(scene.lights, records);
  Outcome outcome;
  outcome.met = double(lights_met(frame, lists.numbers()));
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < width * height; ++i) {
      const std::size_t at = std::size_t(c) * scene.out.stride() + std::size_t(i);
      outcome.lit += brute[at] > 0;
      const double off = std::fabs(double(cut[at]) - brute[at]);
      if (off > 0) outcome.worst = std::max(outcome.worst, brute[at] > 0 ? off / brute[at] : 1e30);
    }
  return outcome;
}

class EveryLookAndRig : public testing::TestWithParam<Case> {};

TEST_P(EveryLookAndRig, NoPixelIsFurtherThanAsked) {
  UnrangedScene scene = make_scene(*GetParam().look, *GetParam().rig, 300);
  const std::vector<float> brute = shaded(scene, scene.frame, {});
  for (const double error : {0.01, 0.1}) {
    const Outcome outcome = cut_and_compare(scene, brute, error);
    EXPECT_LE(outcome.worst, error);
    EXPECT_GT(outcome.lit, 1000);
  }
}

INSTANTIATE_TEST_SUITE_P(LightTree, EveryLookAndRig, testing::ValuesIn(every_case()),
                         [](const auto& info) { return std::string(info.param.look->name) + "_" + info.param.rig->name; });

/// Eight lamps, sampled more and more finely.
void lamps(Random& random, LightRecord& light) {
  const float lamp = std::floor(between(random, 0, 8));
  light.position[0] = 4 * std::sin(lamp) + between(random, -0.4f, 0.4f);
  light.position[1] = 5, light.position[2] = 4 * std::cos(3 * lamp) + between(random, -0.4f, 0.4f);
}

TEST(LightTree, LightsThatAreMetGrowFarSlowerThanLights) {
  double before = 0;
  for (const int lights : {1000, 10'000, 100'000}) {
    UnrangedScene scene = make_scene(looks[0], {"lamps", lamps}, lights);
    const LightTree tree(scene.lights, scene.begin);
    const LightCuts cuts(tree, scene.programs, scene.tables, 0.01);
    LightLists lists;
    Frame frame = scene.frame;
    FrameBounds bounds(scene.planes, frame, width);
    frame.lists = lists.add(bounds, {scene.lights, scene.begin, tree}, cuts, std::size_t(1) << 28);
    const double met = double(lights_met(frame, lists.numbers()));
    EXPECT_LT(met, lights / 4);
    if (before > 0) {
      EXPECT_LT(met, 3 * before) << lights;
    }
    before = met;
  }
}

TEST(LightTree, ThereIsNoneForFewLightsOrWhereALightTakesLightAway) {
  UnrangedScene few = make_scene(looks[0], rigs[0], 20), dark = make_scene(looks[0], rigs[0], 100);
  EXPECT_TRUE(LightTree(few.lights, few.begin).empty());
  EXPECT_EQ(few.lights.size(), 20u);
  dark.lights[50].intensity[1] = -1;
  EXPECT_TRUE(LightTree(dark.lights, dark.begin).empty());
}

/// Through the program: unranged lights beside a ranged one, a spot, and one for the sphere alone.
TEST(LightTree, ShadeKeepsToTheErrorThatItIsGiven) {
  const TemporaryFolder folder;
  MadeUpGBuffer made = MadeUpGBuffer::of_size(200, 120);
  made.with({"albedo.R", "albedo.G", "albedo.B", "roughness", "id"});
  write_gbuffer(folder / "in.exr", made);
  Random random(2);
  std::string rig = R"({"relume": 1, "ids": "id", "lights": [)"
                    R"({"type": "point", "position": [0, 1, 2], "intensity": [5, 5, 5], "falloff": "windowed", "range": 3},)"
                    R"({"type": "point", "position": [2, 2, 2], "intensity": [9, 0, 0], "include": ["1"]},)"
                    R"({"type": "spot", "position": [0, 4, 0], "direction": [0, -1, 0], "intensity": [9, 9, 9]})";
  for (int k = 0; k < 400; ++k)
    rig += R"(,{"type": "point", "intensity": [1, 0.8, 0.5], "position": [)" + std::to_string(3 + between(random, -0.2f, 0.2f)) + ", " +
           std::to_string(4 + between(random, -0.2f, 0.2f)) + ", " + std::to_string(between(random, -0.2f, 0.2f)) + "]}";
  std::ofstream(folder / "rig.json") << rig << "]}";
  const auto shade = [&](const std::string& name, const std::vector<std::string>& options) {
    std::vector<std::string> all{"shade",      (folder / "in.exr").string(),
                                 "-l",         (folder / "rig.json").string(),
                                 "-o",         (folder / name).string(),
                                 "--device",   "twin",
                                 "--diffuse",  "lambert",
                                 "--specular", "ggx"};
    all.insert(all.end(), options.begin(), options.end());
    const ProgramRun run = run_program(all);
    EXPECT_EQ(run.code, 0) << run.err;
    return std::pair(read_channels(folder / name), run.err);
  };
  const Channels plain = shade("plain.exr", {}).first, exact = shade("exact.exr", {"--error", "0"}).first;
  const auto [cut, said] = shade("cut.exr", {"--error", "0.02"});
  EXPECT_NE(said.find("within 2% of brute force; of 400 unranged lights"), std::string::npos) << said;
  bool differs = false;
  for (const char* channel : {"R", "G", "B"})
    for (std::size_t i = 0; i < plain.at(channel).size(); ++i) {
      const float brute = plain.at(channel)[i];
      ASSERT_EQ(brute, exact.at(channel)[i]);
      ASSERT_LE(std::fabs(cut.at(channel)[i] - brute), 0.02f * brute);
      differs |= cut.at(channel)[i] != brute;
    }
  EXPECT_TRUE(differs);
}

}  // namespace
}  // namespace relume
