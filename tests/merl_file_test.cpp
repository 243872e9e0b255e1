// MERL's format: written and read, as published, and refused in one line where it is something else.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>

#include "host/merl.h"
#include "tests/random_table.h"
#include "tests/refusal.h"
#include "tests/run_program.h"

namespace relume {
namespace {

TEST(MerlFile, ComesBackAsWritten) {
  const TemporaryFolder folder;
  const MerlTable table = random_table(7, 5, 8, 0.9);
  write_merl(table, folder / "t.binary", false);
  EXPECT_EQ(std::filesystem::file_size(folder / "t.binary"), 12u + 3 * 8 * 7 * 5 * 8);
  const MerlTable read = read_merl(folder / "t.binary");
  EXPECT_EQ(read.theta_h, 7);
  EXPECT_EQ(read.theta_d, 5);
  EXPECT_EQ(read.phi_d, 8);
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < table.entries(); ++i) {
      if (table.f[c][i] < 0)
        EXPECT_LT(read.f[c][i], 0);
      else
        EXPECT_FLOAT_EQ(read.f[c][i], table.f[c][i]);
    }
}

// BRDFRead.cpp, which comes with the files: index = phi_d + 180 (theta_d + 90 theta_h), planes red, green, blue, times 1, 1.15 and 1.66 over 1500.
TEST(MerlFile, IsThePublishedFormat) {
  const TemporaryFolder folder;
  std::vector<double> numbers(3 * 90 * 90 * 180, 0.0);
  const std::size_t at = 33 + 180 * (22 + 90 * 11), plane = 90 * 90 * 180;
  numbers[at] = 1500;
  numbers[plane + at] = 3000;
  numbers[2 * plane + at] = -0.5;
  std::ofstream out(folder / "t.binary", std::ios::binary);
  const std::int32_t counts[] = {90, 90, 180};
  out.write(reinterpret_cast<const char*>(counts), sizeof counts);
  out.write(reinterpret_cast<const char*>(numbers.data()), std::streamsize(numbers.size() * sizeof(double)));
  out.close();
  const MerlTable table = read_merl(folder / "t.binary");
  EXPECT_EQ(table.at(11, 22, 33), at);
  EXPECT_FLOAT_EQ(table.f[0][at], 1.0f);
  EXPECT_FLOAT_EQ(table.f[1][at], 2.3f);
  EXPECT_LT(table.f[2][at], 0);
  const MerlAngles angles = angles_of(table, 11, 22, 33);
  EXPECT_NEAR(angles.theta_h, std::pow(11.5 / 90, 2) * std::numbers::pi / 2, 1e-12);
  EXPECT_NEAR(angles.theta_d, 22.5 * std::numbers::pi / 180, 1e-12);
  EXPECT_NEAR(angles.phi_d, 33.5 * std::numbers::pi / 180, 1e-12);
}

TEST(MerlFile, WhatIsNoTableIsRefusedInOneLine) {
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& name, std::array<std::int32_t, 3> counts, std::vector<double> numbers) {
    std::ofstream out(folder / name, std::ios::binary);
    out.write(reinterpret_cast<const char*>(counts.data()), sizeof counts);
    out.write(reinterpret_cast<const char*>(numbers.data()), std::streamsize(numbers.size() * sizeof(double)));
    out.close();
    return after((folder / name).string() + ": ", error_of([&] { read_merl(folder / name); }));
  };
  const std::vector<double> good(3 * 2 * 2 * 2, 1.0);
  EXPECT_EQ(refused("good.binary", {2, 2, 2}, good), "not at \"" + (folder / "good.binary").string() + ": \": no error");
  std::vector<double> bad = good;
  bad[5] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refused("nan.binary", {2, 2, 2}, bad).find("is no MERL table: number 5 is not finite"), 0u);
  bad[5] = 1e300;
  EXPECT_EQ(refused("huge.binary", {2, 2, 2}, bad).find("is no MERL table: number 5 is not finite"), 0u);
  EXPECT_EQ(refused("below.binary", {2, 2, 2}, std::vector<double>(24, -1.0)).find("holds no measurement"), 0u);
  EXPECT_EQ(refused("odd.binary", {2, 2, 3}, std::vector<double>(36, 1.0)).find("has 3 bins of phi_d, which must be even"), 0u);
  EXPECT_EQ(refused("negative.binary", {-90, 90, 180}, {}).find("is no MERL table: its counts are -90 90 180"), 0u);
  EXPECT_EQ(refused("vast.binary", {1 << 30, 1 << 30, 1 << 30}, {}).find("is no MERL table: its counts are 1073741824"), 0u);
  EXPECT_EQ(refused("short.binary", {90, 90, 180}, good).find("has 204 bytes where its counts need 34992012"), 0u);
  EXPECT_EQ(refused("long.binary", {2, 2, 2}, std::vector<double>(25, 1.0)).find("has 212 bytes where its counts need 204"), 0u);
  std::ofstream(folder / "text.binary") << "hello";
  EXPECT_NE(error_of([&] { read_merl(folder / "text.binary"); }).find(": is too short for a MERL table's header"), std::string::npos);
  EXPECT_EQ(error_of([&] { read_merl(folder / "none.binary"); }), (folder / "none.binary").string() + ": no such file");
  EXPECT_EQ(error_of([&] { read_merl(folder.path()); }), folder.path().string() + ": is no regular file");
}

}  // namespace
}  // namespace relume
