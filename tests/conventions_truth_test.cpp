// One scene in the conventions of many renderers, relit without a flag: each file to within 1 dB of what knowing all about it gives.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>

#include "tests/channels.h"
#include "tests/psnr.h"
#include "tests/run_program.h"

namespace relume {
namespace {

namespace fs = std::filesystem;

/// All files where the corpus lies beside the project, else the few that the project keeps.
const fs::path folder = (fs::exists(RELUME_CORPUS) ? fs::path(RELUME_CORPUS) : fs::path(RELUME_SOURCE) / "tests/data/corpus") / "conventions";

struct Case {
  std::string name;
  double ceiling = 0;  ///< dB: what the file's precision, filter and codec leave to who knows the answer
};

/// The table of INDEX.md: the file's name first, the ceiling sixth.
std::vector<Case> cases() {
  std::vector<Case> all;
  std::ifstream in(folder / "INDEX.md");
  const std::regex row(R"(\| (\w+)\.exr \|([^|]*\|){4} ([0-9.]+) \|.*)");
  for (std::string line; std::getline(in, line);)
    if (std::smatch match; std::regex_match(line, match, row)) all.push_back({match[1], std::stod(match[3])});
  return all;
}

/// The reference's channel over the file's data window.
std::vector<float> cut(const std::vector<float>& whole, const Window& display, const Window& window) {
  std::vector<float> part;
  for (int y = window.min_y; y < window.max_y; ++y)
    for (int x = window.min_x; x < window.max_x; ++x) part.push_back(whole[std::size_t((y - display.min_y) * display.width() + x - display.min_x)]);
  return part;
}

/// Pixels that the file does not spoil.
std::vector<bool> sound(const nlohmann::json& answer, const Window& window) {
  std::vector<bool> chosen(std::size_t(window.pixels()), true);
  for (const auto& defect : answer["defects"])
    for (const auto& pixel : defect["pixels"])
      chosen[std::size_t((pixel[1].get<int>() - window.min_y) * window.width() + pixel[0].get<int>() - window.min_x)] = false;
  return chosen;
}

TEST(ConventionsTruth, WithoutAFlagWithinADecibelOfTheAnswer) {
  ASSERT_GE(cases().size(), 4u) << folder;
  std::printf("| conventions                      |    dB | ceiling |\n");
  for (const Case& c : cases()) {
    const auto answer = nlohmann::json::parse(std::ifstream(folder / (c.name + ".answer.json")));
    const fs::path file = folder / (c.name + ".exr"), reference_file = folder / answer["reference"].get<std::string>();
    const TemporaryFolder temporary;
    const std::string out = (temporary / "out.exr").string();
    const ProgramRun run = run_program({"shade", file.string(), "-l", (folder / answer["rig"].get<std::string>()).string(), "-o", out, "--quiet"});
    EXPECT_EQ(run.code, 0) << c.name << ": " << run.err;
    if (run.code != 0) continue;
    const Window window = ExrFile(out).parts().front().data_window;
    const Window display = ExrFile(reference_file).parts().front().data_window;
    Rgb reference = rgb_of(read_channels(reference_file));
    for (std::vector<float>& channel : reference) channel = cut(channel, display, window);
    const double db = psnr(rgb_of(read_channels(out)), reference, sound(answer, window));
    std::printf("| %-32s | %5.1f | %7.1f |\n", c.name.c_str(), db, c.ceiling);
    EXPECT_GE(db, c.ceiling - 1) << c.name;
  }
}

}  // namespace
}  // namespace relume
