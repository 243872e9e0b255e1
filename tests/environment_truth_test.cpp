// The ways of evaluating environment lights on what Mitsuba and Cycles wrote, against their own pictures and against the exact sum; prints the table
// that docs/truth.md keeps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "tests/channels.h"
#include "tests/psnr.h"
#include "tests/run_program.h"

namespace relume {
namespace {

namespace fs = std::filesystem;

struct Way {
  const char* name;
  std::vector<std::string> options;
  double least;  ///< dB against the exact sum
};

const std::vector<Way> ways{{"exact", {"--environment", "exact"}, 0},
                            {"sampled, 64", {"--environment", "sampled", "--samples", "64"}, 35},
                            {"median cut, 256", {"--environment", "median_cut", "--environment-lights", "256"}, 30},
                            {"prefiltered", {"--environment", "prefiltered"}, 20}};

/// A case's files, what Relume is told beside them, the light that the renderer computed, and the pixels that show a surface.
struct EnvironmentCase {
  fs::path folder;
  std::vector<std::string> options;
  Rgb reference;
  std::vector<bool> chosen;
};

EnvironmentCase mitsuba_case(const fs::path& folder) {
  const Channels gbuffer = read_channels(folder / "gbuffer.exr");
  EnvironmentCase test{folder, {"--materials", (folder / "materials.json").string()}, rgb_of(read_channels(folder / "reference.exr")), {}};
  for (const float depth : gbuffer.at("depth.T")) test.chosen.push_back(depth > 0);
  return test;
}

EnvironmentCase blender_case(const fs::path& folder) {
  const Channels gbuffer = read_channels(folder / "gbuffer.exr"), reference = read_channels(folder / "reference.exr");
  EnvironmentCase test{folder, {}, rgb_of(reference, "ViewLayer.DiffDir."), {}};
  const Rgb colour = rgb_of(reference, "ViewLayer.DiffCol.");
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < colour[c].size(); ++i) test.reference[c][i] *= colour[c][i];
  if (reference.contains("ViewLayer.GlossDir.R")) {
    const Rgb glossy = rgb_of(reference, "ViewLayer.GlossDir."), tint = rgb_of(reference, "ViewLayer.GlossCol.");
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t i = 0; i < colour[c].size(); ++i) test.reference[c][i] += glossy[c][i] * tint[c][i];
  }
  for (const float depth : gbuffer.at("ViewLayer.Depth.Z")) test.chosen.push_back(depth < 1e9f);
  return test;
}

std::vector<EnvironmentCase> all_cases() {
  std::vector<EnvironmentCase> cases;
  for (const char* renderer : {"mitsuba", "blender"}) {
    std::vector<fs::path> folders;
    for (const auto& entry : fs::directory_iterator(fs::path(RELUME_CORPUS) / renderer))
      if (text_of_file(entry.path() / "rig.json").find("\"environment\"") != std::string::npos) folders.push_back(entry.path());
    std::sort(folders.begin(), folders.end());
    for (const fs::path& folder : folders) cases.push_back(std::string(renderer) == "mitsuba" ? mitsuba_case(folder) : blender_case(folder));
  }
  return cases;
}

Rgb shaded(const EnvironmentCase& test, const Way& way) {
  const TemporaryFolder temporary;
  std::vector<std::string> arguments{"shade", (test.folder / "gbuffer.exr").string(), "--lights", (test.folder / "rig.json").string(),
                                     "-o",    (temporary / "out.exr").string(),       "--quiet"};
  arguments.insert(arguments.end(), test.options.begin(), test.options.end());
  arguments.insert(arguments.end(), way.options.begin(), way.options.end());
  const ProgramRun run = run_program(arguments);
  EXPECT_EQ(run.code, 0) << test.folder << ": " << run.err;
  return run.code == 0 ? rgb_of(read_channels(temporary / "out.exr")) : test.reference;
}

TEST(EnvironmentTruth, FourWays) {
  if (!fs::exists(RELUME_CORPUS)) GTEST_SKIP() << "the corpus is not beside the project";
  std::printf("| %-28s |", "against: renderer / exact sum");
  for (const Way& way : ways) std::printf(" %-15s |", way.name);
  std::printf("\n");
  int cases = 0;
  for (const EnvironmentCase& test : all_cases()) {
    std::printf("| %-28s |", test.folder.filename().c_str());
    Rgb exact;
    for (const Way& way : ways) {
      const Rgb image = shaded(test, way);
      if (exact[0].empty()) exact = image;
      const double truth = psnr(image, test.reference, test.chosen), sum = psnr(image, exact, test.chosen);
      way.least == 0 ? std::printf(" %5.1f           |", truth) : std::printf(" %5.1f / %5.1f   |", truth, sum);
      EXPECT_GE(truth, way.least == 0 ? 45 : 0) << test.folder;
      EXPECT_GE(sum, way.least) << test.folder << ", " << way.name;
    }
    std::printf("\n");
    ++cases;
  }
  EXPECT_GE(cases, 5);
}

}  // namespace
}  // namespace relume
