// relume plot: the numbers against closed forms, the figures as files that other programs open, what is refused.
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <sstream>

#include "figure/figure.h"
#include "gbuffer/picture.h"
#include "host/table.h"
#include "lab/arrangement.h"
#include "lab/scale.h"
#include "tests/run_program.h"

namespace relume {
namespace {

using std::numbers::pi;

double cosine(double degrees) { return std::cos(degrees * pi / 180); }

/// The program's table, and what it said.
struct Plotted {
  Table table;
  std::string out;

  std::vector<double> numbers(const std::string& column) const {
    EXPECT_GE(table.column(column), 0) << column;
    return table.numbers(table.column(column));
  }
};

Plotted plotted(std::vector<std::string> arguments) {
  const TemporaryFolder folder;
  arguments.insert(arguments.begin(), "plot");
  arguments.insert(arguments.end(), {"--device", "twin", "--csv", (folder / "numbers.csv").string()});
  const ProgramRun run = run_program(arguments);
  EXPECT_EQ(run.code, 0) << run.err;
  return {parse_table(text_of_file(folder / "numbers.csv")), run.out};
}

std::string refused(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "plot");
  arguments.insert(arguments.end(), {"--device", "twin"});
  const ProgramRun run = run_program(arguments);
  EXPECT_EQ(run.code, 2) << run.out;
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  return run.err;
}

double most(const std::vector<double>& numbers) { return *std::max_element(numbers.begin(), numbers.end()); }

TEST(Plot, LambertIsAlbedoOverPiEverywhere) {
  const Plotted p = plotted({"--brdf", "lambert", "--set", "albedo=0.8,0.4,0.2", "--view", "30"});
  const std::vector<double> light = p.numbers("light"), r = p.numbers("f_r.r"), b = p.numbers("f_r.diffuse.b"), g = p.numbers("reflectance.g");
  EXPECT_GT(light.size(), 360u);
  for (std::size_t i = 0; i < light.size(); ++i) {
    EXPECT_NEAR(r[i], 0.8 / pi, 1e-6);
    EXPECT_NEAR(b[i], 0.2 / pi, 1e-6);
    EXPECT_NEAR(g[i], 0.4 / pi * cosine(light[i]), 1e-6);
  }
  EXPECT_EQ(most(p.numbers("f_r.specular.r")), 0);
  EXPECT_NE(p.out.find("lambert: highest f_r "), std::string::npos) << p.out;
}

TEST(Plot, PhongsTipStandsAtTheMirrorDirectionHoweverSharp) {
  for (const double e : {8.0, 1000.0, 10000.0}) {
    const Plotted p = plotted({"--brdf", "phong", "--set", "exponent=" + std::to_string(e), "--set", "ks=0.5", "--view", "37"});
    const std::vector<double> f = p.numbers("f_r.r"), light = p.numbers("light");
    const std::size_t tip = std::size_t(std::max_element(f.begin(), f.end()) - f.begin());
    EXPECT_NEAR(f[tip] / ((e + 2) / (2 * pi) * 0.5), 1, 1e-5) << e;
    EXPECT_NEAR(light[tip], 37, 0.05) << e;
    EXPECT_NE(p.out.find("at 37 degrees"), std::string::npos) << p.out;
  }
}

/// The largest step between neighbours in a figure as wide as the tip is high.
TEST(Plot, ASharpLobeIsSmooth) {
  const Plotted p = plotted({"--brdf", "ggx", "--set", "alpha=0.02", "--view", "60"});
  const std::vector<double> f = p.numbers("f_r.r"), light = p.numbers("light");
  const double peak = most(f);
  int bends = 0;
  for (std::size_t i = 1; i + 1 < f.size(); ++i) {
    const double chord = f[i - 1] + (f[i + 1] - f[i - 1]) * (light[i] - light[i - 1]) / (light[i + 1] - light[i - 1]);
    if (std::abs(chord - f[i]) > 2e-3 * peak) ++bends;
  }
  EXPECT_EQ(bends, 0);
  EXPECT_LT(f.size(), 5000u);
}

/// The largest relative difference between f_r and that of exchanged directions, both seen by more than a hundred pairs.
double exchanged(const std::string& brdf, const std::vector<std::string>& set) {
  std::vector<std::string> arguments{"--brdf", brdf, "--swap", "--view", "50"};
  arguments.insert(arguments.end(), set.begin(), set.end());
  const Plotted p = plotted(arguments);
  const std::vector<double> view = p.numbers("view"), light = p.numbers("light"), f = p.numbers("f_r.r");
  const auto key = [](double a, double b) { return std::pair{std::lround(a * 1e5), std::lround(b * 1e5)}; };
  std::map<std::pair<long, long>, double> values;
  for (std::size_t i = 0; i < f.size(); ++i) values[key(view[i], light[i])] = f[i];
  double difference = 0;
  int pairs = 0;
  for (std::size_t i = 0; i < f.size(); ++i) {
    const auto other = values.find(key(light[i], view[i]));
    if (other == values.end() || view[i] == light[i]) continue;
    ++pairs;
    difference = std::max(difference, std::abs(f[i] - other->second) / std::max({f[i], other->second, 1e-3}));
  }
  EXPECT_GT(pairs, 100);
  return difference;
}

TEST(Plot, ExchangedDirectionsCoincideForReciprocalLobesOnly) {
  EXPECT_LT(exchanged("phong", {"--set", "exponent=20"}), 1e-4);
  EXPECT_LT(exchanged("burley+ggx", {"--set", "alpha=0.3"}), 1e-4);
  EXPECT_GT(exchanged("phong_original", {"--set", "exponent=20"}), 0.3);
}

TEST(Plot, SweepsAreDrawnOnceWhereABrdfDoesNotTakeThem) {
  const Plotted p = plotted({"--brdf", "phong,lambert,ggx", "--set", "exponent=8,32", "--set", "albedo=0.8,0.2,0.2;0.5"});
  std::set<std::string> subjects;
  for (const auto& row : p.table.rows) subjects.insert(row[0] + "|" + row[1] + "|" + row[2]);
  EXPECT_EQ(subjects, (std::set<std::string>{"phong|8|", "phong|32|", "lambert||0.8,0.2,0.2", "lambert||0.5", "ggx||"}));
}

TEST(Plot, WhatTheFresnelTermTakesIsTaken) {
  const Plotted p = plotted({"--brdf", "ggx", "--set", "fresnel=none,schlick", "--set", "ks=0.5", "--set", "f0=0.3"});
  std::set<std::string> subjects;
  for (const auto& row : p.table.rows) subjects.insert(row[1] + "|" + row[2] + "|" + row[3]);
  EXPECT_EQ(subjects, (std::set<std::string>{"none|0.5|", "schlick||0.3"}));
}

TEST(Plot, AHemisphereHoldsTheLobeInAllDirections) {
  const Plotted p = plotted({"hemisphere", "--brdf", "phong", "--set", "exponent=50", "--view", "40"});
  const std::vector<double> theta = p.numbers("light.theta"), phi = p.numbers("light.phi"), f = p.numbers("f_r.r");
  const glm::dvec3 mirrored = in_plane(40);
  for (std::size_t i = 0; i < f.size(); ++i) {
    const double sine = std::sin(theta[i] * pi / 180), r_l = mirrored.x * sine * cosine(phi[i]) + mirrored.z * cosine(theta[i]);
    EXPECT_NEAR(f[i], 52 / (2 * pi) * 0.5 * std::pow(std::max(r_l, 0.0), 50), 1e-4);
  }
  EXPECT_GT(f.size(), 50000u);
}

TEST(Plot, ASliceHasTheLobesTipAtThetaH0) {
  const Plotted p = plotted({"slices", "--brdf", "blinn_phong", "--set", "exponent=30"});
  const std::vector<double> theta_h = p.numbers("theta_h"), f = p.numbers("f_r.r");
  for (std::size_t i = 0; i < f.size(); ++i) EXPECT_NEAR(f[i], 32 / (2 * pi) * 0.5 * std::pow(cosine(theta_h[i]), 30), 1e-4);
}

TEST(Plot, AlbedosAreTheClosedFormsAtNormalIncidence) {
  const Plotted p = plotted({"albedo", "--brdf", "lambert+phong", "--set", "albedo=0.25", "--set", "ks=0.5", "--set", "exponent=3"});
  EXPECT_EQ(p.numbers("view").front(), 0);
  EXPECT_NEAR(p.numbers("albedo.r").front(), 0.75, 1e-5);
  EXPECT_NEAR(p.numbers("albedo.specular.g").front(), 0.5, 1e-5);
  for (const double diffuse : p.numbers("albedo.diffuse.b")) EXPECT_NEAR(diffuse, 0.25, 1e-5);
}

TEST(Plot, ALitSphereIsLambertsCosine) {
  const Plotted p = plotted({"spheres", "--brdf", "lambert", "--set", "albedo=0.6", "--light", "0"});
  const std::vector<double> x = p.numbers("x"), y = p.numbers("y"), radiance = p.numbers("radiance.g"), coverage = p.numbers("coverage");
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double u = (2 * (x[i] + 0.5) / 150 - 1) / 0.96, v = (2 * (y[i] + 0.5) / 150 - 1) / 0.96;
    if (u * u + v * v < 0.9) {
      EXPECT_NEAR(radiance[i], 0.6 * std::sqrt(1 - u * u - v * v), 1e-3);
    }
    EXPECT_LE(coverage[i], 1);
  }
  EXPECT_GT(most(coverage), 0.999);
}

TEST(Plot, ScalesHaveRoundMarksInOrder) {
  for (const ScaleKind kind : {ScaleKind::linear, ScaleKind::log, ScaleKind::cube_root})
    for (const double peak : {1e-4, 0.2546, 1.0, 7.3, 796.7, 3.1e6}) {
      const Scale scale(kind, peak);
      const std::vector<double> marks = scale.marks();
      EXPECT_GE(scale.highest(), peak * (1 - 1e-6));
      EXPECT_LE(scale.highest(), peak * 2.6) << name_of(kind);
      EXPECT_EQ(marks.back(), scale.highest());
      EXPECT_NEAR(scale(scale.highest()), 1, 1e-12);
      EXPECT_GE(marks.size(), 4u);
      EXPECT_LE(marks.size(), 8u);
      for (std::size_t i = 1; i < marks.size(); ++i) EXPECT_GT(scale(marks[i]), scale(marks[i - 1]));
    }
}

TEST(Plot, TheColoursAreThoseOfTheLook) {
  for (const char* colour : figure_colours) EXPECT_NE(std::string(figure_look).find(colour), std::string::npos) << colour;
}

class Kinds : public testing::TestWithParam<const char*> {};

TEST_P(Kinds, AreWrittenAsSvgPngAndPdf) {
  const TemporaryFolder folder;
  for (const std::string ending : {"svg", "png", "pdf"}) {
    const std::string file = (folder / ("figure." + ending)).string();
    const ProgramRun run = run_program({"plot", GetParam(), "--brdf", "phong,lambert", "--device", "twin", "--size", "640x400", "-o", file});
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.err, "");
    const std::string text = text_of_file(file);
    if (ending == "svg") {
      EXPECT_TRUE(text.starts_with("<?xml"));
      EXPECT_NE(text.find("</svg>"), std::string::npos);
      EXPECT_EQ(text.find("href='file"), std::string::npos);  // pictures are inside
    } else if (ending == "pdf") {
      EXPECT_TRUE(text.starts_with("%PDF"));
      EXPECT_NE(text.substr(text.size() - 10).find("%%EOF"), std::string::npos);
    } else {
      const Picture picture = read_picture(file);
      EXPECT_EQ(picture.width, 640);
      EXPECT_EQ(picture.height, 400);
      EXPECT_GT(std::set<float>(picture.values.begin(), picture.values.end()).size(), 20u);
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Plot, Kinds, testing::Values("polar", "hemisphere", "albedo", "slices", "spheres"));

TEST(Plot, SpheresAreStoredAsExrToo) {
  const TemporaryFolder folder;
  const std::string file = (folder / "sheet.exr").string();
  ASSERT_EQ(run_program({"plot", "spheres", "--brdf", "lambert,phong", "--device", "twin", "-o", file}).code, 0);
  const Imf::InputFile stored(file.c_str());
  EXPECT_EQ(stored.header().dataWindow().size(), Imath::V2i(299, 149));
}

TEST(Plot, WhatCannotBeDrawnIsRefusedInOneLine) {
  const auto says = [](const std::string& line, const char* what) { EXPECT_NE(line.find(what), std::string::npos) << line; };
  says(refused({"--brdf", "fong", "-o", "x.png"}), "no BRDF \"fong\" (has: lambert");
  says(refused({"blob", "--brdf", "phong", "-o", "x.png"}), "no plot \"blob\" (has: polar, hemisphere");
  says(refused({"--brdf", "phong", "--set", "shine=3", "-o", "x.png"}), "no parameter \"shine\" (has: ");
  says(refused({"--brdf", "phong,lambert", "--set", "alpha=0.1", "-o", "x.png"}), "--set alpha: no parameter of phong, lambert");
  says(refused({"--brdf", "phong", "--set", "exponent=", "-o", "x.png"}), "must be PARAM=VALUE");
  says(refused({"--brdf", "phong", "--set", "exponent=1,,2", "-o", "x.png"}), "is not a number");
  says(refused({"--brdf", "phong", "--set", "ks=0.1,0.2", "-o", "x.png"}), "; separates values");
  for (const char* angle : {"90", "-1", "nan", "1e99"}) says(refused({"--brdf", "phong", "--view", angle, "-o", "x.png"}), "0 to below 90");
  says(refused({"--brdf", "phong", "--view", "1", "--light", "1", "-o", "x.png"}), "one of them stands still");
  says(refused({"--brdf", "phong", "--set", "exponent=1,2,3,4,5,6,7,8,9,10,11,12,13", "-o", "x.png"}), "can be told apart");
  says(refused({"--brdf", "phong", "--set", "exponent=1,2,3,4,5,6,7", "--swap", "-o", "x.png"}), "7 curves with --swap (6 can be told apart)");
  says(refused({"--brdf", "phong", "--swap", "--quantity", "reflectance", "-o", "x.png"}), "--quantity f_r");
  says(refused({"slices", "--brdf", "phong", "--swap", "-o", "x.png"}), "takes no --swap");
  says(refused({"--brdf", "phong", "-o", "x.gif"}), "ends in .svg, .png or .pdf");
  says(refused({"--brdf", "phong", "-o", "x.exr"}), "ends in .svg, .png or .pdf");
  says(refused({"--brdf", "phong", "--size", "1x1", "-o", "x.png"}), "no size");
  says(refused({"--brdf", "phong", "--radius", "sqrt", "-o", "x.png"}), "is none of linear, log, cube_root");
  says(refused({"--brdf", "phong", "--mark", "nan", "-o", "x.png"}), "--mark: degrees");
  says(refused({"--brdf", "phong", "--highest", "0", "-o", "x.png"}), "--highest: a value above 0");
  says(refused({"spheres", "--brdf", "phong", "--exposure", "nan", "-o", "x.png"}), "--exposure: stops");
  says(refused({"--brdf", "phong"}), "nothing to write");
  says(refused({"--brdf", "phong", "-o", "x.png", "--csv", "x.png"}), "is the figure's file");
  says(refused({"hemisphere", "--brdf", "phong", "--set", "exponent=1,2,3,4,5", "--lobes", "total,diffuse,specular", "-o", "x.png"}),
       "15 maps (at most 12)");
}

TEST(Plot, WhatCannotBeWrittenExitsWith5AndLeavesNothing) {
  const TemporaryFolder folder;
  const std::string file = (folder / "figure.svg").string();
  const std::vector<std::string> arguments{"plot", "--brdf", "lambert", "--device", "twin", "-o", file};
  const ProgramRun without = run_program(arguments, {}, "PATH=/nowhere");
  EXPECT_EQ(without.code, 5);
  EXPECT_NE(without.err.find("gnuplot is not here"), std::string::npos) << without.err;
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  EXPECT_EQ(run_program(arguments).code, 0);
  EXPECT_EQ(run_program(arguments).code, 5);  // exists
  EXPECT_EQ(run_program({"plot", "--brdf", "lambert", "--device", "twin", "-o", "/nowhere/figure.svg"}).code, 5);
}

}  // namespace
}  // namespace relume
