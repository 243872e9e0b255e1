// Pictures: sRGB codes by the standard's curve, whole files, and readers that are never guessed.
#include "gbuffer/picture.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <sstream>

#include "tests/files.h"

namespace {

namespace fs = std::filesystem;
using relume::ErrorKind;
using relume::Picture;

/// The 8-bit code that a linear value read back stands for: the curve in double, in the direction that picture.cpp does not compute.
int code_of(double linear) { return int(std::lround(255 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055))); }

TEST(Picture, CodesFollowTheStandardsCurve) {
  const TemporaryFolder folder;
  constexpr int width = 2048;
  Picture picture{width, 1, 1, std::vector<float>(width)};
  for (int i = 0; i < width; ++i) picture.values[std::size_t(i)] = float(i) / (width - 1);
  relume::write_png(folder.path / "a.png", picture, 0, false);
  const Picture back = relume::read_picture(folder.path / "a.png");
  ASSERT_EQ(back.width, width);
  ASSERT_EQ(back.channels, 1);
  for (std::size_t i = 0; i < picture.values.size(); ++i) ASSERT_EQ(code_of(back.values[i]), code_of(picture.values[i])) << picture.values[i];
  EXPECT_EQ(contents(folder.path / "a.png").substr(0, 8), "\x89PNG\r\n\x1a\n");
}

TEST(Picture, ClipsExposesAndDividesByAlpha) {
  const TemporaryFolder folder;
  const float infinity = std::numeric_limits<float>::infinity();
  const Picture picture{2, 2, 4, {0.09f, 0.18f, 0.045f, 0.5f, 9, -1, NAN, 1, infinity, 0, 0.25f, 0, 0.25f, 0.25f, 0.25f, 1}};
  relume::write_png(folder.path / "a.png", picture, 1, false);
  const Picture back = relume::read_picture(folder.path / "a.png");
  ASSERT_EQ(back.channels, 4);
  const std::vector<int> expected = {code_of(0.36), code_of(0.72), code_of(0.18), 128, 255, 0, 0, 255, 255, 0, code_of(0.5), 0,
                                     code_of(0.5),  code_of(0.5),  code_of(0.5),  255};
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_EQ(i % 4 == 3 ? int(std::lround(back.values[i] * 255)) : code_of(back.values[i]), expected[i]) << i;
}

TEST(Picture, ExistingFileStaysUnlessOverwritten) {
  const TemporaryFolder folder;
  const fs::path file = folder.path / "a.png";
  std::ofstream(file) << "old";
  const Picture picture{1, 1, 3, {0, 0, 0}};
  message_of([&] { relume::write_png(file, picture, 0, false); }, ErrorKind::output);
  EXPECT_EQ(contents(file), "old");
  relume::write_png(file, picture, 0, true);
  EXPECT_EQ(relume::read_picture(file).values, picture.values);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path), fs::directory_iterator()), 1);
}

TEST(Picture, FloatFormatsStayLinear) {
  const TemporaryFolder folder;
  // A PFM: little-endian floats, rows from the bottom.
  const float values[] = {0.5f, 2.0f, 0.25f, 1.0f, 0.0f, 3.0f};
  std::ofstream(folder.path / "a.pfm", std::ios::binary).write("PF\n1 2\n-1.0\n", 12).write(reinterpret_cast<const char*>(values), sizeof values);
  const Picture picture = relume::read_picture(folder.path / "a.pfm");
  ASSERT_EQ(picture.height, 2);
  EXPECT_EQ(picture.values, (std::vector<float>{1.0f, 0.0f, 3.0f, 0.5f, 2.0f, 0.25f}));
}

TEST(Picture, WhatIsNoPictureIsRefusedInOneLine) {
  const TemporaryFolder folder;
  const auto read = [](const fs::path& file) { return [file] { relume::read_picture(file); }; };
  std::ofstream(folder.path / "text.png") << "not a picture";
  std::ofstream(folder.path / "text.tif") << "not a picture";
  std::ofstream(folder.path / "a.xyz") << "x";
  message_of(read(folder.path / "text.png"), ErrorKind::input);
  message_of(read(folder.path / "text.tif"), ErrorKind::input);
  EXPECT_NE(message_of(read(folder.path / "a.xyz"), ErrorKind::input).find("png, jpg"), std::string::npos);
  EXPECT_NE(message_of(read(folder.path / "none.png"), ErrorKind::input).find("no such file"), std::string::npos);
  EXPECT_NE(message_of(read("http://127.0.0.1:9/a.png"), ErrorKind::input).find("no such file"), std::string::npos);
  ASSERT_EQ(mkfifo((folder.path / "pipe.png").c_str(), 0600), 0);
  EXPECT_NE(message_of(read(folder.path / "pipe.png"), ErrorKind::input).find("regular"), std::string::npos);
}

}  // namespace
