// Reading EXR: every codec, sample type and storage gives back what OpenEXR wrote; windows, views, limits and refusals.
#include "gbuffer/exr_file.h"

#include <ImfStandardAttributes.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <fstream>
#include <thread>

#include "tests/exr_files.h"
#include "tests/files.h"

namespace {

namespace fs = std::filesystem;
using relume::Destination;
using relume::ErrorKind;
using relume::ExrFile;
using relume::SampleType;
using relume::Window;

std::vector<float> read_plane(const ExrFile& file, int part, const Window& window, const std::string& channel) {
  std::vector<float> plane(std::size_t(window.pixels()), NAN);
  const Destination to{channel, SampleType::float32, plane.data(), 4, std::size_t(window.width()) * 4};
  file.read(part, window, {&to, 1});
  return plane;
}

/// The largest difference from what was written.
float worst_difference(const std::vector<float>& plane, const Window& window, int channel) {
  float worst = 0;
  for (std::size_t i = 0; i < plane.size(); ++i) {
    const float expected = value_at(window.min_x + int(i) % window.width(), window.min_y + int(i) / window.width(), channel);
    const float difference = std::abs(plane[i] - expected);
    if (std::isnan(difference)) return difference;
    worst = std::max(worst, difference);
  }
  return worst;
}

/// What the codec promises: the rest is lossless.
float tolerance(Imf::Compression compression, Imf::PixelType type) {
  if (type == Imf::UINT) return 0;
  const bool b44 = compression == Imf::B44_COMPRESSION || compression == Imf::B44A_COMPRESSION;
  const bool dwa = compression == Imf::DWAA_COMPRESSION || compression == Imf::DWAB_COMPRESSION;
  if (b44 && type == Imf::HALF) return 8;   // 6 bits of a 4x4 block's range
  if (dwa && type == Imf::HALF) return 16;  // channels named R G B A at level 45
  return 0;
}

constexpr Window offset_window{-37, -11, 64, 70};  // 101 x 81: no multiple of tiles, blocks or lanes

class Codec : public testing::TestWithParam<std::tuple<int, bool>> {};

TEST_P(Codec, EveryTypeComesBack) {
  const auto [compression, tiled] = GetParam();
  const TemporaryFolder folder;
  const PartSpec part{"only",
                      "",
                      offset_window,
                      {0, 0, 64, 64},
                      Imf::Compression(compression),
                      tiled,
                      Imf::INCREASING_Y,
                      {{"N.X", Imf::FLOAT}, {"R", Imf::HALF}, {"id", Imf::UINT}}};
  write_file(folder.path / "a.exr", {part});
  const ExrFile file(folder.path / "a.exr");
  ASSERT_EQ(file.parts().size(), 1u);
  EXPECT_EQ(file.parts()[0].data_window, offset_window);
  EXPECT_EQ(file.parts()[0].display_window, (Window{0, 0, 64, 64}));
  const std::vector<Window> windows = {offset_window, {-37, 0, 64, 33}, {-3, 5, 40, 61}, {63, 69, 64, 70}, {-37, -11, -36, 70}};
  for (const Window& window : windows)
    for (int c = 0; c < 3; ++c)
      EXPECT_LE(worst_difference(read_plane(file, 0, window, part.channels[std::size_t(c)].first), window, c),
                tolerance(part.compression, part.channels[std::size_t(c)].second))
          << part.channels[std::size_t(c)].first << " from " << window.min_x << ',' << window.min_y;
}

INSTANTIATE_TEST_SUITE_P(All, Codec, testing::Combine(testing::Range(0, int(Imf::NUM_COMPRESSION_METHODS)), testing::Bool()));

TEST(ExrFile, IsReadFromSeveralThreadsAtOnce) {
  const TemporaryFolder folder;
  for (const Imf::Compression compression : {Imf::ZIP_COMPRESSION, Imf::PIZ_COMPRESSION}) {
    const fs::path path = folder.path / "a.exr";
    write_file(path, {{"only", "", offset_window, {0, 0, 64, 64}, compression, false, Imf::INCREASING_Y, {{"R", Imf::HALF}, {"X", Imf::FLOAT}}}});
    const ExrFile file(path);
    std::vector<std::thread> threads;
    std::atomic<int> wrong{0};
    for (int first = offset_window.min_y; first < offset_window.max_y; first += 9)
      threads.emplace_back([&, first] {
        const Window rows{offset_window.min_x, first, offset_window.max_x, std::min(first + 20, offset_window.max_y)};
        for (int k = 0; k < 20; ++k) wrong += worst_difference(read_plane(file, 0, rows, k % 2 ? "X" : "R"), rows, k % 2) != 0;
      });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(wrong, 0) << compression;
  }
}

TEST(ExrFile, ReadsIntoStridedMemoryOfEveryType) {
  const TemporaryFolder folder;
  const Window window{5, 3, 25, 13};
  write_file(folder.path / "a.exr",
             {{"p", "", window, window, Imf::ZIP_COMPRESSION, false, Imf::INCREASING_Y, {{"A", Imf::HALF}, {"B", Imf::UINT}}}});
  const ExrFile file(folder.path / "a.exr");
  struct Pixel {
    float a;
    std::uint32_t b;
    half c;
  };
  for (const Window& asked : {window, Window{6, 4, 20, 10}}) {
    std::vector<Pixel> pixels(std::size_t(asked.pixels()));
    const std::size_t row = sizeof(Pixel) * std::size_t(asked.width());
    const std::vector<Destination> all = {{"A", SampleType::float32, &pixels[0].a, sizeof(Pixel), row},
                                          {"B", SampleType::uint32, &pixels[0].b, sizeof(Pixel), row},
                                          {"A", SampleType::half_float, &pixels[0].c, sizeof(Pixel), row}};
    file.read(0, asked, all);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const int x = asked.min_x + int(i) % asked.width(), y = asked.min_y + int(i) / asked.width();
      ASSERT_EQ(pixels[i].a, value_at(x, y, 0));
      ASSERT_EQ(pixels[i].b, unsigned(value_at(x, y, 1)));
      ASSERT_EQ(float(pixels[i].c), value_at(x, y, 0));
    }
  }
}

TEST(ExrFile, IdsKeepAllThirtyTwoBits) {
  const TemporaryFolder folder;
  const std::vector<std::uint32_t> ids = {0, 16777217, 4294967295u, 5};
  Imf::Header header(4, 1);
  header.channels().insert("id", Imf::Channel(Imf::UINT));
  {
    Imf::MultiPartOutputFile file((folder.path / "a.exr").c_str(),
                                  [&] {
                                    header.setName("p");
                                    header.setType(Imf::SCANLINEIMAGE);
                                    return &header;
                                  }(),
                                  1);
    Imf::OutputPart out(file, 0);
    Imf::FrameBuffer frame;
    frame.insert("id", Imf::Slice::Make(Imf::UINT, ids.data(), Imath::V2i(0, 0), 4, 1));
    out.setFrameBuffer(frame);
    out.writePixels(1);
  }
  std::vector<std::uint32_t> back(4);
  const Destination to{"id", SampleType::uint32, back.data(), 4, 16};
  ExrFile(folder.path / "a.exr").read(0, {0, 0, 4, 1}, {&to, 1});
  EXPECT_EQ(back, ids);
}

TEST(ExrFile, PartsOfDifferentStorageSizeAndView) {
  const TemporaryFolder folder;
  const Window big{0, 0, 60, 40}, small{10, 10, 30, 21};
  write_file(folder.path / "a.exr",
             {{"left.N", "left", big, big, Imf::PIZ_COMPRESSION, false, Imf::DECREASING_Y, {{"X", Imf::FLOAT}}},
              {"right.N", "right", small, big, Imf::ZIPS_COMPRESSION, true, Imf::INCREASING_Y, {{"X", Imf::HALF}, {"Y", Imf::FLOAT}}}});
  const ExrFile file(folder.path / "a.exr");
  ASSERT_EQ(file.parts().size(), 2u);
  EXPECT_EQ(file.parts()[0].view, "left");
  EXPECT_EQ(file.parts()[1].name, "right.N");
  EXPECT_TRUE(file.parts()[1].has_channel("Y"));
  EXPECT_FALSE(file.parts()[0].has_channel("Y"));
  EXPECT_TRUE(file.views().empty());
  EXPECT_EQ(worst_difference(read_plane(file, 0, big, "X"), big, 0), 0);
  EXPECT_EQ(worst_difference(read_plane(file, 1, small, "Y"), small, 1), 0);
  const std::string message = message_of([&] { read_plane(file, 0, big, "Y"); }, ErrorKind::input);
  EXPECT_NE(message.find("part 0: no channel \"Y\""), std::string::npos) << message;
  message_of([&] { read_plane(file, 2, big, "X"); }, ErrorKind::input);
}

TEST(ExrFile, TruncatedPixelsAreRefusedNamingThePart) {
  const TemporaryFolder folder;
  const Window window{0, 0, 200, 100};
  for (const bool tiled : {false, true}) {
    const fs::path path = folder.path / "a.exr";
    write_file(path, {{"p", "", window, window, Imf::ZIP_COMPRESSION, tiled, Imf::INCREASING_Y, {{"X", Imf::FLOAT}}}});
    fs::resize_file(path, fs::file_size(path) * 2 / 3);
    const ExrFile file(path);
    const std::string message = message_of([&] { read_plane(file, 0, window, "X"); }, ErrorKind::input);
    EXPECT_EQ(message.find(path.string() + ": part 0: "), 0u) << message;
  }
}

TEST(ExrFile, FileThatWasNeverFinishedIsRefused) {
  const TemporaryFolder folder;
  const fs::path whole = folder.path / "a.exr";
  const Window window{0, 0, 64, 64};
  write_file(whole, {{"p", "", window, window, Imf::NO_COMPRESSION, false, Imf::INCREASING_Y, {{"X", Imf::FLOAT}}}});
  std::string bytes(std::size_t(fs::file_size(whole)), 0);
  std::ifstream(whole, std::ios::binary).read(bytes.data(), std::streamsize(bytes.size()));
  // 64 chunks of 4 * 64 + 8 bytes follow the table of 64 * 8; the table is what a killed writer leaves as zeros.
  const std::size_t table = bytes.size() - 64 * (64 * 4 + 8) - 64 * 8;
  std::fill_n(bytes.begin() + std::ptrdiff_t(table), 64 * 8, '\0');
  std::ofstream(whole, std::ios::binary) << bytes;
  const ExrFile file(whole);
  const std::string message = message_of([&] { read_plane(file, 0, window, "X"); }, ErrorKind::input);
  EXPECT_NE(message.find("never finished"), std::string::npos) << message;
}

TEST(ExrFile, WhatIsNoFileToReadIsRefusedAtOnce) {
  const TemporaryFolder folder;
  const auto open = [](const fs::path& path) { return [path] { const ExrFile file(path); }; };
  EXPECT_NE(message_of(open(folder.path / "none.exr"), ErrorKind::input).find("no such file"), std::string::npos);
  EXPECT_NE(message_of(open(folder.path), ErrorKind::input).find("is a folder"), std::string::npos);
  ASSERT_EQ(mkfifo((folder.path / "pipe.exr").c_str(), 0600), 0);
  EXPECT_NE(message_of(open(folder.path / "pipe.exr"), ErrorKind::input).find("not a regular file"), std::string::npos);
  EXPECT_NE(message_of(open("/dev/zero"), ErrorKind::input).find("not a regular file"), std::string::npos);
  std::ofstream(folder.path / "empty.exr").flush();
  EXPECT_NE(message_of(open(folder.path / "empty.exr"), ErrorKind::input).find("not an OpenEXR file"), std::string::npos);
}

TEST(ExrFile, LimitsAreNamed) {
  const TemporaryFolder folder;
  const Window window{0, 0, 100, 50};
  const PartSpec part{"p", "", window, window, Imf::ZIP_COMPRESSION, false, Imf::INCREASING_Y, {{"X", Imf::FLOAT}, {"Y", Imf::FLOAT}}};
  PartSpec second = part;
  second.name = "q";
  const fs::path path = folder.path / "a.exr";
  write_file(path, {part, second});
  const auto open = [&](const relume::ReadLimits& limits) { return [&path, limits] { const ExrFile file(path, limits); }; };
  open({.max_decoded_bytes = 40000, .max_side = 100, .max_parts = 2, .max_channels = 2})();
  EXPECT_NE(message_of(open({.max_decoded_bytes = 39999}), ErrorKind::memory).find("max_decoded_bytes"), std::string::npos);
  EXPECT_NE(message_of(open({.max_side = 99}), ErrorKind::input).find("max_side"), std::string::npos);
  EXPECT_NE(message_of(open({.max_parts = 1}), ErrorKind::input).find("max_parts"), std::string::npos);
  EXPECT_NE(message_of(open({.max_channels = 1}), ErrorKind::input).find("max_channels"), std::string::npos);
}

TEST(ExrFile, SubsampledChannelIsRefusedOnlyWhenAskedFor) {
  const TemporaryFolder folder;
  const fs::path path = folder.path / "a.exr";
  Imf::Header header(8, 8);
  header.setName("p");
  header.setType(Imf::SCANLINEIMAGE);
  header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
  header.channels().insert("RY", Imf::Channel(Imf::FLOAT, 2, 2));
  {
    const std::vector<float> ones(64, 1.0f);
    Imf::MultiPartOutputFile file(path.c_str(), &header, 1);
    Imf::OutputPart out(file, 0);
    Imf::FrameBuffer frame;
    frame.insert("Y", Imf::Slice::Make(Imf::FLOAT, ones.data(), Imath::V2i(0, 0), 8, 8));
    frame.insert(
        "RY", Imf::Slice::Make(Imf::FLOAT, ones.data(), Imath::V2i(0, 0), std::int64_t(8), std::int64_t(8), std::size_t(4), std::size_t(16), 2, 2));
    out.setFrameBuffer(frame);
    out.writePixels(8);
  }
  const ExrFile file(path);
  EXPECT_TRUE(file.parts()[0].has_channel("Y"));
  EXPECT_FALSE(file.parts()[0].has_channel("RY"));
  EXPECT_EQ(read_plane(file, 0, {0, 0, 8, 8}, "Y"), std::vector<float>(64, 1.0f));
  EXPECT_NE(message_of([&] { read_plane(file, 0, {0, 0, 8, 8}, "RY"); }, ErrorKind::input).find("2x2"), std::string::npos);
}

TEST(Attributes, AreFoundWithoutRegardToCase) {
  Imf::Header header;
  header.insert("worldToCamera", Imf::M44fAttribute(Imath::M44f(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16)));
  header.insert("Software", Imf::StringAttribute("Blender"));
  const auto matrix = relume::matrix_attribute(header, "WorldToCamera");
  ASSERT_TRUE(matrix);
  EXPECT_EQ((*matrix)[1], 2);
  EXPECT_EQ((*matrix)[15], 16);
  EXPECT_EQ(relume::text_attribute(header, "software"), "Blender");
  EXPECT_FALSE(relume::matrix_attribute(header, "software"));
  EXPECT_FALSE(relume::text_attribute(header, "none"));
}

}  // namespace
