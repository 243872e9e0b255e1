// Fits of BRDFs to tables: one made of a BRDF gives its parameters back, the right one comes first, bounds hold, and the program says it all.
#include "lab/fit.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "lab/fit_model.h"
#include "lab/tabulate.h"
#include "tests/refusal.h"
#include "tests/run_program.h"

namespace relume {
namespace {

std::shared_ptr<Device> twin() { return open_device("twin"); }

/// Few bins: a fit compares at their middles, where a table is exact.
MerlTable table_of(const std::string& brdf, const std::vector<std::string>& set) { return tabulate(Brdf(brdf, set, twin()), 60, 15, 12); }

Fit fitted(const MerlTable& table, const std::string& brdf, FitMetric metric = FitMetric::log) {
  return fit(brdf, fit_samples(table, metric, 80, "table"), metric, twin());
}

std::vector<double> values_of(const Fit& fit, const std::string& name) {
  for (const FittedParameter& p : fit.parameters)
    if (p.name == name) return p.values;
  ADD_FAILURE() << fit.brdf << " has no " << name;
  return {0, 0, 0};
}

/// Of "albedo=0.5,0.3,0.1"; one number stands for `count`.
std::vector<double> numbers_of(const std::string& setting, std::size_t count) {
  std::istringstream in(setting.substr(setting.find('=') + 1));
  std::vector<double> numbers;
  for (std::string word; std::getline(in, word, ',');) numbers.push_back(std::stod(word));
  numbers.resize(count, numbers.front());
  return numbers;
}

struct Truth {
  std::string brdf;
  std::vector<std::string> set;
};

TEST(Fit, GivesBackTheParametersOfItsOwnTable) {
  const Truth truths[] = {{"lambert+ggx", {"albedo=0.5,0.3,0.1", "alpha=0.3", "f0=0.04,0.06,0.1"}},
                          {"lambert+ggx", {"albedo=0.01,0.02,0.03", "alpha=0.05", "f0=0.9,0.6,0.3"}},
                          {"lambert+phong", {"albedo=0.2,0.3,0.4", "exponent=40", "ks=0.3,0.2,0.1"}},
                          {"oren_nayar+none", {"albedo=0.7,0.5,0.2", "sigma=0.5"}},
                          {"lambert+cook_torrance", {"albedo=0.3,0.3,0.2", "alpha=0.15", "f0=0.2,0.1,0.05"}}};
  for (const Truth& truth : truths)
    for (const FitMetric metric : {FitMetric::log, FitMetric::cube_root, FitMetric::cosine}) {
      const Fit found = fitted(table_of(truth.brdf, truth.set), truth.brdf, metric);
      EXPECT_LT(found.residual, 2e-5) << truth.brdf << " " << name_of(metric);
      for (const std::string& setting : truth.set) {
        const std::vector<double> values = values_of(found, setting.substr(0, setting.find('='))), wanted = numbers_of(setting, values.size());
        for (std::size_t c = 0; c < values.size(); ++c)
          EXPECT_NEAR(values[c], wanted[c], 2e-3 * wanted[c] + 1e-4) << truth.brdf << " " << setting << " " << name_of(metric);
      }
    }
}

TEST(Fit, NoiseOfFivePercentMovesParametersLittle) {
  MerlTable table = table_of("lambert+ggx", {"albedo=0.5,0.3,0.1", "alpha=0.2", "f0=0.3"});
  std::mt19937 random(5);
  std::normal_distribution<float> noise(1, 0.05f);
  for (auto& plane : table.f)
    for (float& value : plane)
      if (value > 0) value *= noise(random);
  const Fit found = fitted(table, "lambert+ggx");
  EXPECT_NEAR(values_of(found, "alpha")[0], 0.2, 0.006);
  EXPECT_NEAR(values_of(found, "albedo")[1], 0.3, 0.01);
  EXPECT_NEAR(values_of(found, "f0")[2], 0.3, 0.02);
}

TEST(Fit, TheBrdfThatMadeTheTableIsNearest) {
  const MerlTable table = table_of("lambert+beckmann", {"albedo=0.5,0.3,0.1", "alpha=0.2", "f0=0.3"});
  const double own = fitted(table, "lambert+beckmann").residual;
  for (const char* other : {"lambert", "lambert+ggx", "lambert+phong", "lambert+blinn_phong"})
    EXPECT_GT(fitted(table, other).residual, 10 * own) << other;
}

TEST(Fit, StaysWithinTheParametersRanges) {
  MerlTable table = table_of("lambert", {"albedo=0.9,0.5,0"});
  for (float& value : table.f[0]) value *= 2;  // an albedo of 1.8
  const Fit found = fitted(table, "lambert");
  EXPECT_NEAR(values_of(found, "albedo")[0], 1, 1e-3);
  EXPECT_LE(values_of(found, "albedo")[0], 1);
  EXPECT_NEAR(values_of(found, "albedo")[1], 0.5, 1e-4);
  EXPECT_GE(values_of(found, "albedo")[2], 0);
  EXPECT_TRUE(found.parameters[0].at_bound);
}

TEST(FitModel, CoordinatesGoThroughTheWholeRangeAndNoFurther) {
  for (const char* name : {"alpha", "exponent", "albedo", "ior", "eta", "k", "sigma"}) {
    const FreeParameter p{&parameter_named(name), name, 0};
    for (const double share : {0.01, 0.3, 0.9}) {
      const double value = p.parameter->lowest + share * (p.parameter->highest - p.parameter->lowest);
      EXPECT_NEAR(p.value_at(p.coordinate_of(value)), value, 1e-9 * p.parameter->highest) << name;
    }
    for (double u = -20; u < 20; u += 0.1) {
      EXPECT_GE(p.value_at(u), p.parameter->lowest) << name;
      EXPECT_LE(p.value_at(u), p.parameter->highest) << name;
    }
  }
}

TEST(FitModel, WhatCannotBeFittedIsSaid) {
  const std::vector<FitSample> samples = fit_samples(stand_in_table(8, 4, 4), FitMetric::log, 80, "table");
  EXPECT_NE(error_of([&] { FitModel("merl", samples, twin()); }).find("has no parameter to fit"), std::string::npos);
  EXPECT_NE(error_of([&] { FitModel("plastic+none", samples, twin()); }).find("table is made for constants"), std::string::npos);
  EXPECT_NE(error_of([&] { FitModel("ggxx", samples, twin()); }).find("no BRDF \"ggxx\""), std::string::npos);
  EXPECT_NE(error_of([] { fit_samples(stand_in_table(8, 4, 4), FitMetric::log, 0.01, "table"); }).find("table: nothing is measured"),
            std::string::npos);
}

// Every BRDF that is fitted unasked has parameters and gives finite residuals.
TEST(Fit, EveryDefaultBrdfFitsTheStandIn) {
  const MerlTable table = stand_in_table(20, 6, 4);
  for (const std::string& name : fitted_by_default()) {
    const Fit found = fitted(table, name);
    EXPECT_TRUE(std::isfinite(found.residual) && std::isfinite(found.plain_residual)) << name;
    EXPECT_FALSE(found.parameters.empty()) << name;
  }
}

TEST(Fit, TheProgramPrintsJsonCsvAndTheFigure) {
  const TemporaryFolder folder;
  const auto in = [&](const char* name) { return (folder / name).string(); };
  write_merl(table_of("lambert+phong", {"albedo=0.4", "exponent=30"}), folder / "t.binary", false);
  const ProgramRun run =
      run_program({"fit", in("t.binary"), "--brdf", "lambert,lambert+phong", "--json", "--csv", in("fit.csv"), "--device", "twin"});
  ASSERT_EQ(run.code, 0) << run.err;
  const auto json = nlohmann::json::parse(run.out);
  ASSERT_EQ(json["fits"].size(), 2u);
  EXPECT_EQ(json["fits"][0]["brdf"], "lambert+phong");
  EXPECT_NEAR(json["fits"][0]["parameters"]["exponent"], 30, 0.1);
  EXPECT_LT(json["fits"][0]["residual"], json["fits"][1]["residual"]);
  EXPECT_EQ(text_of_file(folder / "fit.csv").find("brdf,residual,plain_residual,parameter,r,g,b\nlambert+phong,"), 0u);
  EXPECT_EQ(run_program({"fit", in("t.binary"), "--brdf", "lambert", "--csv", in("fit.csv")}).code, 5);  // exists
  EXPECT_EQ(run_program({"fit", in("t.binary"), "--figure", in("fit.jpg")}).code, 2);
  EXPECT_EQ(run_program({"fit", in("fit.csv")}).code, 2);
  const ProgramRun drawn = run_program({"fit", in("t.binary"), "--brdf", "lambert", "--figure", in("fit.svg"), "--device", "twin"});
  if (drawn.code == 5) GTEST_SKIP() << "no gnuplot here";
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_NE(text_of_file(folder / "fit.svg").find("<svg"), std::string::npos);
}

}  // namespace
}  // namespace relume
