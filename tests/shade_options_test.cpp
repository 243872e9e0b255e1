// What users type: every option of shade that shapes the output, and the commands beside it, through the program.
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "gbuffer/picture.h"
#include "gbuffer/write_exr.h"
#include "host/lobes.h"
#include "tests/channels.h"
#include "tests/make_gbuffer.h"
#include "tests/run_program.h"

namespace relume {
namespace {

const char* const key_light = R"({"relume": 1, "lights": [{"type": "point", "name": "key", "position": [2, 3, 4], "intensity": [40, 38, 35]}]})";
const char* const sun_light =
    R"({"relume": 1, "lights": [{"type": "directional", "name": "key", "direction": [1, -1, -1], "intensity": [1, 1, 2]}]})";

class ShadeOptions : public testing::Test {
 protected:
  void SetUp() override {
    MadeUpGBuffer made;
    made.with({"albedo.R", "albedo.G", "albedo.B", "roughness", "metallic", "A"});
    made.header = [](Imf::Header& header) {
      header.pixelAspectRatio() = 1.25f;
      header.insert("studio:shot", Imf::StringAttribute("sc042"));
      Imf::addWhiteLuminance(header, 92);
    };
    write_gbuffer(in("in.exr"), made);
    put("key.json", key_light);
    put("sun.json", sun_light);
  }
  std::string in(const std::string& name) const { return (folder_ / name).string(); }
  void put(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }

  ProgramRun run(const std::string& output, std::vector<std::string> options, const std::vector<std::string>& rigs = {"key.json"},
                 const std::string& input = {}) const {
    std::vector<std::string> all{"shade", in("in.exr"), "-o", in(output), "--device", "twin", "--quiet"};
    for (const std::string& rig : rigs) {
      all.push_back("--lights");
      all.push_back(rig == "-" ? rig : in(rig));
    }
    all.insert(all.end(), options.begin(), options.end());
    return run_program(all, input);
  }
  Channels shade(const std::string& output, const std::vector<std::string>& options, const std::vector<std::string>& rigs = {"key.json"},
                 const std::string& input = {}) const {
    const ProgramRun result = run(output, options, rigs, input);
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.err, "");
    return result.code == 0 ? read_channels(in(output)) : Channels{};
  }

  TemporaryFolder folder_;
};

double largest_error(const Channels& a, const Channels& b) {
  double largest = a.size() == b.size() ? 0 : INFINITY;
  for (const auto& [name, values] : a)
    for (std::size_t i = 0; i < values.size(); ++i) largest = std::max(largest, std::fabs(double(values[i]) - b.at(name)[i]));
  return largest;
}

float brightest(const Channels& a) {
  float most = 0;
  for (const auto& [name, values] : a) most = std::max(most, *std::max_element(values.begin(), values.end()));
  return most;
}

TEST_F(ShadeOptions, TypesAndCodecs) {
  const Channels reference = shade("float.exr", {"--float"});
  ASSERT_FALSE(reference.empty());
  const double peak = brightest(reference);
  EXPECT_EQ(ExrFile(in("float.exr")).parts()[0].channels[0].type, SampleType::float32);
  for (const bool half : {false, true})
    for (const std::string& codec : compression_names()) {
      const std::string name = codec + (half ? "-half.exr" : ".exr");
      const Channels image = shade(name, {"--compression", codec, half ? "--half" : "--float"});
      ASSERT_FALSE(image.empty());
      EXPECT_EQ(ExrFile(in(name)).parts()[0].channels[0].type, half ? SampleType::half_float : SampleType::float32);
      const bool lossy = codec.starts_with("dwa") || (half && codec.starts_with("b44"));
      const bool rounded = half || codec == "pxr24";  // 24 bits
      EXPECT_LE(largest_error(reference, image), peak * (lossy ? 0.05 : half ? 5e-4 : rounded ? 2e-5 : 0)) << name;
    }
  EXPECT_EQ(run("both.exr", {"--half", "--float"}).code, 2);
}

TEST_F(ShadeOptions, LayersHaveTheirNames) {
  const auto names = [&](const std::string& output, const std::vector<std::string>& options) {
    std::set<std::string> all;
    for (const auto& [name, values] : shade(output, options, {"key.json", "sun.json"})) all.insert(name);
    return all;
  };
  const std::set<std::string> total{"R", "G", "B", "A"};
  EXPECT_EQ(names("a.exr", {}), total);
  EXPECT_EQ(names("b.exr", {"--layers", "total"}), total);
  std::set<std::string> more = total;
  for (const char* layer : {"diffuse", "specular"})
    for (const char* c : {".R", ".G", ".B"}) more.insert(layer + std::string(c));
  EXPECT_EQ(names("c.exr", {"--layers", "diffuse,specular"}), more);
  std::set<std::string> lights = total;
  for (const char* layer : {"ambient", "light.key", "light.key_2"})  // the second rig's light of the same name
    for (const char* c : {".R", ".G", ".B"}) lights.insert(layer + std::string(c));
  EXPECT_EQ(names("d.exr", {"--layers", "lights"}), lights);
}

TEST_F(ShadeOptions, RigsAddUpAndOneMayComeFromStandardInput) {
  const Channels key = shade("key.exr", {}), sun = shade("sun.exr", {}, {"sun.json"}), both = shade("both.exr", {}, {"key.json", "sun.json"});
  const Channels piped = shade("piped.exr", {}, {"key.json", "-"}, sun_light);
  ASSERT_FALSE(key.empty() || sun.empty() || both.empty() || piped.empty());
  EXPECT_EQ(both, piped);
  EXPECT_NE(key, sun);
  for (const char* c : {"R", "G", "B"})
    for (std::size_t i = 0; i < 64 * 64; ++i) {
      const double sum = double(key.at(c)[i]) + sun.at(c)[i];
      ASSERT_NEAR(both.at(c)[i], sum, 1e-6 * sum);
    }
}

TEST_F(ShadeOptions, InputAttributesAreKept) {
  ASSERT_FALSE(shade("out.exr", {}).empty());
  const ExrFile file(in("out.exr"));
  const Imf::Header& header = file.parts()[0].header;
  EXPECT_EQ(header.pixelAspectRatio(), 1.25f);
  EXPECT_EQ(text_attribute(header, "studio:shot"), "sc042");
  EXPECT_EQ(Imf::whiteLuminance(header), 92);
  EXPECT_TRUE(matrix_attribute(header, "worldToCamera"));
  EXPECT_EQ(text_attribute(header, "relume:gbuffer"), "in.exr");
  EXPECT_EQ(text_attribute(header, "relume:device"), "twin");
  EXPECT_EQ("relume " + text_attribute(header, "relume:version").value_or("") + "\n", run_program({"--version"}).out);
}

/// The picture's linear values are those of the EXR, doubled by a stop and clipped, to the nearest of 256 codes.
TEST_F(ShadeOptions, PictureShowsTheImage) {
  const Channels image = shade("out.exr", {"--png", in("out.png"), "--exposure", "1"});
  ASSERT_FALSE(image.empty());
  const Picture picture = read_picture(in("out.png"));
  ASSERT_EQ(picture.width, 64);
  ASSERT_EQ(picture.channels, 4);
  const char* const names[] = {"R", "G", "B", "A"};
  for (std::size_t i = 0; i < 64 * 64; ++i)
    for (std::size_t c = 0; c < 4; ++c) {
      const double wanted = std::clamp(double(image.at(names[c])[i]) * (c < 3 ? 2 : 1), 0.0, 1.0);
      ASSERT_NEAR(picture.values[4 * i + c], wanted, 0.0045) << i;  // half a code at white, where the curve is steepest: 2.4/255/2
    }
}

TEST_F(ShadeOptions, SummaryForPrograms) {
  const ProgramRun result = run("out.exr", {"--json", "--layers", "diffuse", "--crop", "8,8,40,24"});
  ASSERT_EQ(result.code, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json["device"], "twin");
  EXPECT_EQ(json["convention"], "generic");
  EXPECT_EQ(json["width"], 32);
  EXPECT_EQ(json["height"], 16);
  EXPECT_EQ(json["lights"], 1);
  EXPECT_EQ(json["bands"], 1);
  EXPECT_EQ(json["programs"], nlohmann::json({"gltf + ggx (schlick, smith)"}));
  EXPECT_GT(json["surface_pixels"], 100);
  EXPECT_GT(json["seconds"]["shade"], 0.0);
}

TEST_F(ShadeOptions, Compare) {
  ASSERT_FALSE(shade("a.exr", {}).empty() || shade("b.exr", {"--half"}).empty());
  EXPECT_EQ(run_program({"compare", in("a.exr"), in("a.exr")}).code, 0);
  EXPECT_EQ(run_program({"compare", in("a.exr"), in("b.exr")}).code, 1);
  EXPECT_EQ(run_program({"compare", in("a.exr"), in("b.exr"), "--tolerance", "0.01"}).code, 0);
  EXPECT_EQ(run_program({"compare", in("a.exr"), in("none.exr")}).code, 2);
  const ProgramRun result = run_program({"compare", in("b.exr"), in("a.exr"), "--json"});
  EXPECT_EQ(result.code, 1);
  const auto json = nlohmann::json::parse(result.out);
  ASSERT_EQ(json["layers"].size(), 2u);  // colour and alpha
  EXPECT_EQ(json["layers"][0]["layer"], "");
  EXPECT_GT(json["layers"][0]["psnr"], 60.0);
  EXPECT_GT(json["layers"][0]["max_error"], 0.0);
  EXPECT_EQ(json["layers"][1]["psnr"], "infinite");
  EXPECT_EQ(json["layers"][0]["values"], 3 * 64 * 64);
}

nlohmann::json listed(const std::string& what) {
  const ProgramRun result = run_program({"list", what, "--json"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_GT(run_program({"list", what}).out.size(), 100u);
  return nlohmann::json::parse(result.out);
}

TEST(List, HoldsEveryLobeLightAndConvention) {
  std::set<std::string> named, wanted;
  const nlohmann::json brdfs = listed("brdfs");
  for (const auto& lobe : brdfs["brdfs"]) {
    named.insert(lobe["half"].get<std::string>() + " " + lobe["name"].get<std::string>());
    EXPECT_FALSE(lobe["source"].get<std::string>().empty()) << lobe["name"];
    EXPECT_FALSE(lobe["parameters"].empty()) << lobe["name"];
  }
  for (const Lobe& lobe : diffuse_lobes()) wanted.insert("diffuse " + std::string(lobe.name));
  for (const Lobe& lobe : specular_lobes()) wanted.insert("specular " + std::string(lobe.name));
  EXPECT_EQ(named, wanted);
  EXPECT_EQ(brdfs["fresnel"].size(), fresnels().size());
  const auto names = [](const nlohmann::json& list) {
    std::set<std::string> all;
    for (const auto& entry : list) all.insert(entry["name"].get<std::string>());
    return all;
  };
  for (const char* light : {"point", "spot", "directional", "ambient"}) EXPECT_TRUE(names(listed("lights")).contains(light)) << light;
  for (const char* convention : {"blender", "mitsuba", "pbrt", "generic"})
    EXPECT_TRUE(names(listed("conventions")).contains(convention)) << convention;
}

/// A command and those below it, as words to type, with what --help prints of each.
std::map<std::vector<std::string>, std::string> helps(const std::vector<std::string>& command = {}) {
  std::vector<std::string> words = command;
  words.push_back("--help");
  const ProgramRun run = run_program(words);
  EXPECT_EQ(run.code, 0) << run.err;
  std::map<std::vector<std::string>, std::string> all{{command, run.out}};
  std::istringstream lines(run.out.substr(std::min(run.out.find("Subcommands:"), run.out.size())));
  static const std::regex entry("  ([a-z_-]+) +.*");
  std::smatch match;
  for (std::string line; std::getline(lines, line);) {
    if (!std::regex_match(line, match, entry)) continue;
    words.back() = match[1];
    all.merge(helps(words));
  }
  return all;
}

TEST(Help, EveryCommandHasAnExample) {
  const auto all = helps();
  for (const char* command : {"shade", "inspect", "doctor", "compare", "devices", "list", "evaluate", "bench"})
    EXPECT_TRUE(all.contains({command})) << command;
  for (const auto& [command, help] : all) {
    if (help.find("Subcommands:") != std::string::npos) continue;
    std::string words = "relume";
    for (const std::string& word : command) words += " " + word;
    const std::size_t example = help.find("Example");
    ASSERT_NE(example, std::string::npos) << words;
    EXPECT_NE(help.find(words, example), std::string::npos) << words;
  }
}

std::set<std::string> options_in(const std::string& text) {
  static const std::regex option("--[a-z][a-z-]*[a-z]");
  return {std::sregex_token_iterator(text.begin(), text.end(), option), {}};
}

TEST(Help, DocumentsNameTheOptionsThatThereAre) {
  std::set<std::string> there;
  for (const auto& [command, help] : helps())
    if (!command.empty()) there.merge(options_in(help));
  EXPECT_EQ(options_in(text_of_file(std::filesystem::path(RELUME_SOURCE) / "docs/formats.md")), there);
}

}  // namespace
}  // namespace relume
