// relume evaluate: closed forms, columns that are kept, tables that are refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "tests/run_program.h"

namespace relume {
namespace {

std::vector<std::vector<std::string>> rows_of(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back();
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, ',');) rows.back().push_back(field);
  }
  return rows;
}

ProgramRun evaluate(const std::string& brdf, const std::vector<std::string>& options, const std::string& csv) {
  std::vector<std::string> all{"evaluate", brdf, "--device", "twin"};
  all.insert(all.end(), options.begin(), options.end());
  return run_program(all, csv);
}

double schlick(double f0, double v_h) { return f0 + (1 - f0) * std::pow(1 - v_h, 5); }

double ggx(double n_l, double n_v, double l_v, double a, double f0) {
  const double size = std::sqrt(2 + 2 * l_v), n_h = (n_l + n_v) / size, spread = n_h * n_h * (a * a - 1) + 1;
  const auto stretched = [&](double c) { return std::sqrt(a * a + (1 - a * a) * c * c); };
  return a * a / (M_PI * spread * spread) * 0.5 / (n_l * stretched(n_v) + n_v * stretched(n_l)) * schlick(f0, size / 2);
}

TEST(Evaluate, ClosedForms) {
  struct Form {
    const char* brdf;
    std::vector<std::string> options;
    double (*f_r)(double n_l, double n_v, double l_v);
  };
  const Form forms[] = {
      {"lambert", {"--set", "albedo=0.5"}, [](double, double, double) { return 0.5 / M_PI; }},
      {"phong",
       {"--set", "ks=0.5", "--set", "exponent=20"},
       [](double n_l, double n_v, double l_v) { return 0.5 * 22 / (2 * M_PI) * std::pow(std::max(0.0, 2 * n_l * n_v - l_v), 20); }},
      {"blinn_phong",
       {"--set", "ks=0.5", "--set", "exponent=20"},
       [](double n_l, double n_v, double l_v) { return 0.5 * 22 / (2 * M_PI) * std::pow((n_l + n_v) / std::sqrt(2 + 2 * l_v), 20); }},
      {"ggx", {"--set", "roughness=0.5"}, [](double n_l, double n_v, double l_v) { return ggx(n_l, n_v, l_v, 0.25, 0.04); }},
      {"ggx", {"--set", "alpha=0.1", "--set", "f0=0.9"}, [](double n_l, double n_v, double l_v) { return ggx(n_l, n_v, l_v, 0.1, 0.9); }}};
  const double cosines[][3] = {{0.7, 0.8, 0.9}, {0.3, 0.9, 0.4}, {0.95, 0.95, 0.99}, {0.2, 0.3, -0.5}, {1, 1, 1}};
  std::string csv = "n_l,n_v,l_v\n";
  for (const auto& c : cosines) csv += std::to_string(c[0]) + "," + std::to_string(c[1]) + "," + std::to_string(c[2]) + "\n";
  for (const Form& form : forms) {
    const ProgramRun result = evaluate(form.brdf, form.options, csv);
    ASSERT_EQ(result.code, 0) << result.err;
    const auto rows = rows_of(result.out);
    ASSERT_EQ(rows.size(), 6u);
    EXPECT_EQ(rows[0], (std::vector<std::string>{"n_l", "n_v", "l_v", "f_r", "reflectance"}));
    for (std::size_t i = 0; i < 5; ++i) {
      const double f_r = form.f_r(cosines[i][0], cosines[i][1], cosines[i][2]);
      EXPECT_NEAR(std::stod(rows[i + 1][3]), f_r, 1e-5 * f_r + 1e-12) << form.brdf << " row " << i;
      EXPECT_NEAR(std::stod(rows[i + 1][4]), f_r * cosines[i][0], 1e-5 * f_r + 1e-12) << form.brdf << " row " << i;
    }
  }
}

TEST(Evaluate, Columns) {
  // Others are kept as they are; a parameter's column is for its row, colours have three.
  const ProgramRun result =
      evaluate("lambert", {}, "name,n_l,albedo.r,albedo.g,albedo.b,n_v,l_v\n\"a, b\",0.5,0.1,0.2,0.3,0.5,0.9\nc,1,1,1,0,0.5,0.5\n");
  ASSERT_EQ(result.code, 0) << result.err;
  std::istringstream lines(result.out);
  std::string header, first, second;
  std::getline(lines, header);
  std::getline(lines, first);
  std::getline(lines, second);
  EXPECT_EQ(header, "name,n_l,albedo.r,albedo.g,albedo.b,n_v,l_v,f_r.r,f_r.g,f_r.b,reflectance.r,reflectance.g,reflectance.b");
  EXPECT_EQ(first.substr(0, 34), "\"a, b\",0.5,0.1,0.2,0.3,0.5,0.9,0.0");
  EXPECT_EQ(second.substr(0, 19), "c,1,1,1,0,0.5,0.5,0");
  const auto rows = rows_of(second);
  EXPECT_NEAR(std::stod(rows[0][7]), 1 / M_PI, 1e-7);
  EXPECT_NEAR(std::stod(rows[0][11]), 1 / M_PI, 1e-7);
  EXPECT_EQ(rows[0][12], "0");
}

TEST(Evaluate, BadTables) {
  const auto refused = [](const std::string& brdf, const std::vector<std::string>& options, const std::string& csv) {
    const ProgramRun result = evaluate(brdf, options, csv);
    EXPECT_EQ(result.code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    return result.err;
  };
  EXPECT_NE(refused("lambert", {}, "n_l,n_v\n1,1\n").find("no column l_v"), std::string::npos);
  EXPECT_NE(refused("lambert", {}, "n_l,n_v,l_v\n1,1,1\n1,x,1\n").find("3"), std::string::npos);
  EXPECT_NE(refused("lambert", {}, "n_l,n_v,l_v\n1,1,1\n1,1\n").find("3"), std::string::npos);
  EXPECT_NE(refused("lambert", {}, "").find("relume: "), std::string::npos);
  EXPECT_NE(refused("lambent", {}, "n_l,n_v,l_v\n").find("no BRDF \"lambent\" (has: lambert, "), std::string::npos);
  EXPECT_NE(refused("ggx", {"--set", "roughness=7"}, "n_l,n_v,l_v\n").find("7 is out of range (0..1)"), std::string::npos);
}

}  // namespace
}  // namespace relume
