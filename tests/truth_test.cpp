// Truth: `relume shade` on what renderers wrote, against what they computed under the new lights; prints the table that docs/truth.md keeps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/channels.h"
#include "tests/psnr.h"
#include "tests/run_program.h"

namespace relume {
namespace {

namespace fs = std::filesystem;

/// The whole corpus where it lies beside the project, else the few cases that the project keeps.
const fs::path corpus = fs::exists(RELUME_CORPUS) ? fs::path(RELUME_CORPUS) : fs::path(RELUME_SOURCE) / "tests/data/corpus";

nlohmann::json json_of(const fs::path& file) { return nlohmann::json::parse(std::ifstream(file)); }

std::vector<fs::path> cases_of(const std::string& renderer) {
  std::vector<fs::path> cases;
  for (const auto& entry : fs::directory_iterator(corpus / renderer))
    if (fs::exists(entry.path() / "gbuffer.exr")) cases.push_back(entry.path());
  std::sort(cases.begin(), cases.end());
  return cases;
}

Rgb product(const Rgb& a, const Rgb& b) {
  Rgb c = a;
  for (int k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < c[k].size(); ++i) c[k][i] *= b[k][i];
  return c;
}

Rgb sum(const Rgb& a, const Rgb& b) {
  Rgb c = a;
  for (int k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < c[k].size(); ++i) c[k][i] += b[k][i];
  return c;
}

/// Shades into `folder` and reads the result; fails the test and returns nothing where the program did not exit 0.
Channels shade(const TemporaryFolder& folder, const fs::path& gbuffer, const fs::path& rig, std::vector<std::string> options) {
  const std::string out = (folder / "out.exr").string();
  std::vector<std::string> arguments{"shade",   gbuffer.string(), "--lights",         rig.string(),    "-o",   out, "--overwrite",
                                     "--quiet", "--layers",       "diffuse,specular", "--environment", "exact"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const ProgramRun run = run_program(arguments);
  EXPECT_EQ(run.code, 0) << gbuffer << ": " << run.err;
  return run.code == 0 ? read_channels(out) : Channels{};
}

void print_row(const std::string& name, const std::vector<double>& numbers, double wanted) {
  std::printf("| %-32s |", name.c_str());
  for (const double number : numbers) number < 0 ? std::printf("     - |") : std::printf(" %5.1f |", number);
  std::printf(" %5.1f |\n", wanted);
}

TEST(Truth, Mitsuba) {
  if (!fs::exists(RELUME_CORPUS)) std::printf("the corpus is not beside the project: only the cases of tests/data/corpus\n");
  std::printf("| mitsuba                          |    dB | wanted |\n");
  for (const fs::path& folder : cases_of("mitsuba")) {
    const nlohmann::json rig = json_of(folder / "rig.json"), facts = json_of(folder / "case.json");
    const std::set<std::string> later{"rect", "sphere", "disk"};
    if (std::any_of(rig["lights"].begin(), rig["lights"].end(), [&](const auto& light) { return later.contains(light["type"]); })) continue;
    const TemporaryFolder temporary;
    const Channels image = shade(temporary, folder / "gbuffer.exr", folder / "rig.json", {"--materials", (folder / "materials.json").string()});
    if (image.empty()) continue;
    const Channels gbuffer = read_channels(folder / "gbuffer.exr"), reference = read_channels(folder / "reference.exr");
    std::vector<bool> chosen(gbuffer.begin()->second.size());
    const bool filtered = folder.filename().string().starts_with("aa");
    for (std::size_t i = 0; i < chosen.size(); ++i) chosen[i] = filtered ? reference.at("A")[i] > 0.999f : gbuffer.at("depth.T")[i] > 0;
    for (int k = 0; fs::exists(folder / ("visibility" + std::to_string(k) + ".exr")); ++k) {  // the lit pixels of a case with shadows
      const Channels visible = read_channels(folder / ("visibility" + std::to_string(k) + ".exr"));
      for (std::size_t i = 0; i < chosen.size(); ++i) chosen[i] = chosen[i] && visible.begin()->second[i] == 1;
    }
    const double db = psnr(rgb_of(image), rgb_of(reference), chosen), wanted = facts["expect_db"];
    print_row(folder.filename().string(), {db}, wanted);
    EXPECT_GE(db, wanted) << folder.filename();
  }
}

TEST(Truth, Pbrt) {
  if (!fs::exists(RELUME_CORPUS)) std::printf("the corpus is not beside the project: only the cases of tests/data/corpus\n");
  std::printf("| pbrt                             |    dB | wanted |\n");
  for (const fs::path& folder : cases_of("pbrt")) {
    const nlohmann::json facts = json_of(folder / "case.json");
    const TemporaryFolder temporary;
    const Channels image = shade(temporary, folder / "gbuffer.exr", folder / "rig.json", facts["relume_shade"]);
    if (image.empty()) continue;
    const Channels gbuffer = read_channels(folder / "gbuffer.exr"), reference = read_channels(folder / "reference.exr");
    std::vector<bool> chosen(reference.at("R").size(), true);
    const bool ambient = folder.filename() == "ambient-f32";  // pbrt shows the sky there: the background is left out
    for (std::size_t i = 0; ambient && i < chosen.size(); ++i)
      chosen[i] = gbuffer.at("Ns.X")[i] != 0 || gbuffer.at("Ns.Y")[i] != 0 || gbuffer.at("Ns.Z")[i] != 0;
    const double db = psnr(rgb_of(image), rgb_of(reference), chosen), wanted = facts["psnr_at_least"];
    print_row(folder.filename().string(), {db}, wanted);
    // shadows and coated are there to show a limit: cast shadows, and a random walk that no closed form has.
    const bool limit = folder.filename() == "shadows-f16" || folder.filename() == "coated-f16";
    EXPECT_TRUE(limit || db >= wanted) << folder.filename() << ": " << db;
  }
}

/// A pass of a Blender file by its 4.x or 5.x name, for a view layer and view.
Rgb pass(const Channels& channels, const std::string& view_layer, const std::string& view, const char* old_name, const char* new_name) {
  for (const char* name : {old_name, new_name})
    for (const std::string& infix : {view.empty() ? "." : "." + view + ".", std::string(".")}) {
      const std::string prefix = view_layer + "." + name + infix;
      if (channels.contains(prefix + "R")) return rgb_of(channels, prefix);
    }
  ADD_FAILURE() << "no pass " << old_name;
  return {};
}

/// What a Blender case calls for beside its G-buffer.
struct BlenderCase {
  fs::path folder;
  nlohmann::json facts;
  std::string view_layer = "ViewLayer", view;

  explicit BlenderCase(const fs::path& path) : folder(path), facts(json_of(path / "case.json")) {
    const std::vector<std::string> options = facts["relume_shade"];
    for (std::size_t i = 0; i + 1 < options.size(); ++i) {
      if (options[i] == "--view-layer") view_layer = options[i + 1];
      if (options[i] == "--view") view = options[i + 1];
    }
  }
  fs::path rig() const {
    if (fs::exists(folder / "rig.json")) return folder / "rig.json";  // what glTF does not hold: environments
    const std::string stated = facts["rig"].value("file", "rig.gltf");
    return folder / stated;
  }
  bool reached_by_this_issue() const {
    const std::string name = folder.filename();
    for (const char* later : {"soft", "bump", "sequence"})
      if (name.starts_with(later)) return false;
    return true;
  }
};

TEST(Truth, Blender) {
  if (!fs::exists(RELUME_CORPUS)) std::printf("the corpus is not beside the project: only the cases of tests/data/corpus\n");
  std::printf("| blender                          | diff. | gloss | total | wanted |\n");
  for (const fs::path& folder : cases_of("blender")) {
    const BlenderCase test(folder);
    if (!test.reached_by_this_issue()) continue;
    const TemporaryFolder temporary;
    const Channels image = shade(temporary, folder / "gbuffer.exr", test.rig(), test.facts["relume_shade"]);
    if (image.empty()) continue;
    const Channels gbuffer = read_channels(folder / "gbuffer.exr");
    const Channels reference = read_channels(folder / test.facts.value("reference_file", "reference.exr"));
    const auto of = [&](const char* old_name, const char* new_name) { return pass(reference, test.view_layer, test.view, old_name, new_name); };
    const Rgb diffuse = product(of("DiffDir", "Diffuse Direct"), of("DiffCol", "Diffuse Color"));
    const Rgb glossy = product(of("GlossDir", "Glossy Direct"), of("GlossCol", "Glossy Color"));
    std::string depth = test.view_layer + ".Depth." + (test.view.empty() ? "" : test.view + ".") + "Z";
    if (!gbuffer.contains(depth)) depth = test.view_layer + ".Depth.Z";
    std::vector<bool> chosen(diffuse[0].size());
    for (std::size_t i = 0; i < chosen.size(); ++i) chosen[i] = gbuffer.at(depth)[i] < 1e9f;
    const double db = psnr(rgb_of(image), sum(diffuse, glossy), chosen), wanted = test.facts["expect_db"];
    print_row(folder.filename().string(), {psnr(rgb_of(image, "diffuse."), diffuse, chosen), psnr(rgb_of(image, "specular."), glossy, chosen), db},
              wanted);
    EXPECT_GE(db, wanted) << folder.filename();
  }
}

}  // namespace
}  // namespace relume
