// relume check-brdf: the table, JSON and CSV that it prints, its exit codes, what it refuses.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/run_program.h"

namespace relume {
namespace {

using Json = nlohmann::json;

ProgramRun check(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "check-brdf");
  return run_program(arguments);
}

const Json& law(const Json& brdf, const std::string& name) {
  for (const Json& l : brdf["laws"])
    if (l["law"] == name) return l;
  throw std::runtime_error("no law " + name);
}

TEST(CheckBrdf, TellsTheLecturesPhongsApart) {
  const ProgramRun run = check({"phong", "phong_original", "lambert_original", "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  const Json all = Json::parse(run.out);
  EXPECT_TRUE(all["plausible"].get<bool>());
  ASSERT_EQ(all["brdfs"].size(), 3u);
  for (const Json& brdf : all["brdfs"]) {
    const bool original = brdf["name"] != "phong";
    EXPECT_EQ(law(brdf, "conserving")["holds"], !original) << brdf["name"];
    EXPECT_EQ(law(brdf, "conserving")["claimed"], !original) << brdf["name"];
    EXPECT_TRUE(law(brdf, "positive")["holds"].get<bool>()) << brdf["name"];
    EXPECT_EQ(law(brdf, "reciprocal")["holds"], brdf["name"] != "phong_original");
    EXPECT_FALSE(law(brdf, "conserving")["meaning"].get<std::string>().empty());
  }
  EXPECT_NEAR(all["brdfs"][0]["furnace"]["greatest"].get<double>(), 3.14159265, 1e-5);  // pi times as bright as Lambert
  EXPECT_NEAR(all["brdfs"][1]["furnace"]["greatest"].get<double>(), 6.2831853, 1e-4);   // exponent 0 reflects to everywhere alike
  EXPECT_NEAR(all["brdfs"][2]["furnace"]["greatest"].get<double>(), 1, 1e-5);
  EXPECT_TRUE(all["terms"].empty());  // none of them has facets
}

TEST(CheckBrdf, TableNamesWhatIsBrokenByHowMuchAndWhere) {
  const ProgramRun run = check({"blinn_phong", "--set", "exponent=50"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("specular blinn_phong: not conserving: reflects 3.7"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("at exponent=50, view 0 degrees"), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find("FAILS"), std::string::npos);
}

TEST(CheckBrdf, FacetsBringTheirTerms) {
  const ProgramRun run = check({"ggx", "--set", "alpha=0.3", "--set", "shadowing=smith", "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  const Json all = Json::parse(run.out);
  EXPECT_GT(all["terms"].size(), 10u);
  EXPECT_TRUE(law(all["brdfs"][0], "facets")["holds"].get<bool>());
}

TEST(CheckBrdf, CsvAndFigure) {
  const TemporaryFolder folder;
  const std::string csv = (folder / "a.csv").string(), figure = (folder / "a.svg").string();
  const ProgramRun run = check({"lambert", "oren_nayar", "--set", "albedo=0.5", "--csv", csv, "--figure", figure});
  ASSERT_EQ(run.code, 0) << run.err;
  const std::string text = text_of_file(csv);
  EXPECT_EQ(text.substr(0, text.find('\n')), "half,brdf,setting,view_degrees,albedo,error");
  EXPECT_NE(text.find("diffuse,lambert,albedo=0.5,60,0."), std::string::npos) << text;
  EXPECT_NE(text_of_file(figure).find("</svg>"), std::string::npos);
  EXPECT_EQ(check({"lambert", "--csv", csv}).code, 5);
  EXPECT_EQ(check({"lambert", "--csv", csv, "--overwrite"}).code, 0);
}

TEST(CheckBrdf, RefusesInOneLine) {
  const auto refused = [](const std::vector<std::string>& arguments, const std::string& sentence) {
    const ProgramRun run = check(arguments);
    EXPECT_EQ(run.code, 2) << sentence;
    EXPECT_NE(run.err.find(sentence), std::string::npos) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_EQ(run.out, "");
  };
  refused({"gxx"}, "no BRDF \"gxx\" (has: lambert, ");
  refused({"lambert", "--set", "alpha=0.2"}, "alpha");
  refused({"phong", "--set", "exponent=-1"}, "exponent");
  refused({"phong", "--set", "exponent"}, "exponent");
  refused({"ggx", "--set", "shadowing=none"}, "shadowing");
  refused({"ggx", "--set", "alpha=nan"}, "alpha");
  refused({"--all", "ggx"}, "--all");
  refused({"lambert", "--figure", "furnace.bmp"}, "furnace.bmp");
}

}  // namespace
}  // namespace relume
