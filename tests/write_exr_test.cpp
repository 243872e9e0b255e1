// Writing EXR: what is written reads back, and a failure at any byte leaves the folder as it was.
#include "gbuffer/write_exr.h"

#include <ImfChannelList.h>
#include <ImfIntAttribute.h>
#include <ImfPreviewImage.h>
#include <ImfStandardAttributes.h>
#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <set>
#include <sstream>

#include "tests/files.h"

namespace {

namespace fs = std::filesystem;
using relume::Destination;
using relume::ErrorKind;
using relume::ExrFile;
using relume::ExrWriter;
using relume::OutputFormat;
using relume::SampleType;
using relume::Window;

/// The message of an Error{output}.
std::string refusal(const std::function<void()>& work) { return message_of(work, ErrorKind::output); }

constexpr Window offset_window{-20, 7, 81, 66};  // 101 x 59
const std::vector<std::string> two_channels = {"R", "diffuse.X"};

/// Noise, so that no codec makes the file small; the seed is fixed.
std::vector<float> noise(const Window& window) {
  std::vector<float> pixels(std::size_t(window.pixels()) * 2);
  std::uint32_t state = 12345;
  for (float& value : pixels) {
    state = state * 1664525u + 1013904223u;
    value = float(state >> 8) / float(1 << 24);
  }
  return pixels;
}

void write(const fs::path& file, const OutputFormat& format, const Window& window, const std::vector<float>& pixels, int band,
           const Imf::Header& like = {}) {
  ExrWriter writer(file, format, like, window, {0, 0, 64, 64}, two_channels, {{"relume:version", "1"}});
  const std::size_t row = std::size_t(window.width()) * 8;
  for (int y = 0; y < window.height(); y += band) {
    const float* first = pixels.data() + std::size_t(y) * row / 4;
    const std::vector<relume::Source> sources = {{"R", first, 8, row}, {"diffuse.X", first + 1, 8, row}};
    writer.write_rows(std::min(band, window.height() - y), sources);
  }
  writer.commit();
}

std::vector<float> read_back(const fs::path& path, const Window& window) {
  std::vector<float> pixels(std::size_t(window.pixels()) * 2);
  const std::size_t row = std::size_t(window.width()) * 8;
  const std::vector<Destination> all = {{"R", SampleType::float32, pixels.data(), 8, row},
                                        {"diffuse.X", SampleType::float32, pixels.data() + 1, 8, row}};
  ExrFile(path).read(0, window, all);
  return pixels;
}

float worst_difference(const std::vector<float>& a, const std::vector<float>& b) {
  float worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::isnan(a[i] - b[i])) return NAN;
    worst = std::max(worst, std::abs(a[i] - b[i]));
  }
  return worst;
}

TEST(WriteExr, EveryCodecAndTypeReadsBack) {
  const TemporaryFolder folder;
  const std::vector<float> pixels = noise(offset_window);
  // Of values in 0..1. pxr24 keeps 16 bits of a float; b44 and dwa spare floats and channels that are no colour, but a half R is theirs to bend.
  const std::set<std::string> lossy = {"b44", "b44a", "dwaa", "dwab"};
  for (const std::string& name : relume::compression_names())
    for (const SampleType type : {SampleType::float32, SampleType::half_float}) {
      const fs::path file = folder.path / (name + (type == SampleType::float32 ? "f" : "h") + ".exr");
      write(file, {type, name}, offset_window, pixels, 13);
      const bool half = type == SampleType::half_float;
      const float tolerance = lossy.contains(name) ? 0.3f : half ? 1.0f / 2048 : name == "pxr24" ? 1.0f / 65536 : 0.0f;
      EXPECT_LE(worst_difference(read_back(file, offset_window), pixels), tolerance) << file;
      const ExrFile back(file);
      EXPECT_EQ(back.parts()[0].data_window, offset_window);
      EXPECT_EQ(back.parts()[0].display_window, (Window{0, 0, 64, 64}));
      EXPECT_EQ(back.parts()[0].channels[0].type, type);
      EXPECT_EQ(relume::text_attribute(back.parts()[0].header, "relume:version"), "1");
    }
  EXPECT_EQ(names_in(folder.path).size(), 20u);
  const std::string message = message_of(
      [&] {
        write(folder.path / "x.exr", {SampleType::float32, "jpeg"}, offset_window, pixels, 59);
      },
      ErrorKind::input);
  EXPECT_NE(message.find("dwab"), std::string::npos) << message;
}

TEST(WriteExr, HalfKeepsFiniteValuesFinite) {
  const TemporaryFolder folder;
  const float infinity = std::numeric_limits<float>::infinity();
  const Window window{0, 0, 3, 1};
  write(folder.path / "a.exr", {SampleType::half_float}, window, {1e9f, -1e9f, 65519.0f, infinity, NAN, 1.5f}, 1);
  const std::vector<float> back = read_back(folder.path / "a.exr", window);
  EXPECT_EQ(back[0], 65504);
  EXPECT_EQ(back[1], -65504);
  EXPECT_EQ(back[2], 65504);
  EXPECT_EQ(back[3], infinity);
  EXPECT_TRUE(std::isnan(back[4]));
  EXPECT_EQ(back[5], 1.5f);
}

TEST(WriteExr, KeepsWhatStillHoldsAndDropsWhatDoesNot) {
  const TemporaryFolder folder;
  Imf::Header like(10, 10, 2.0f);
  like.screenWindowWidth() = 3;
  like.setName("part");
  like.setView("left");
  like.setTileDescription({16, 16});
  like.setPreviewImage({2, 2});
  like.compression() = Imf::PIZ_COMPRESSION;
  like.lineOrder() = Imf::DECREASING_Y;
  like.channels().insert("Z", Imf::Channel(Imf::UINT));
  like.insert("worldToCamera", Imf::M44fAttribute(Imath::M44f(2)));
  like.insert("multiView", Imf::StringVectorAttribute({"left", "right"}));
  like.insert("BlenderMultiChannel", Imf::StringAttribute("Blender V2.55.1 and newer"));
  like.insert("cryptomatte/1234567/name", Imf::StringAttribute("objects"));
  like.insert("tiff:RowsPerStrip", Imf::IntAttribute(0));
  like.insert("owner", Imf::StringAttribute("me"));
  like.insert("relume:version", Imf::IntAttribute(7));
  write(folder.path / "a.exr", {}, offset_window, noise(offset_window), 59, like);
  const ExrFile file(folder.path / "a.exr");
  const Imf::Header& header = file.parts()[0].header;
  EXPECT_EQ(header.pixelAspectRatio(), 2);
  EXPECT_EQ(header.screenWindowWidth(), 3);
  EXPECT_EQ(relume::text_attribute(header, "owner"), "me");
  EXPECT_EQ(relume::text_attribute(header, "relume:version"), "1");
  EXPECT_EQ(relume::matrix_attribute(header, "worldToCamera")->at(0), 2);
  const std::vector<std::string> names = relume::attribute_names(header);
  for (const char* gone : {"name", "view", "tiles", "preview", "multiView", "BlenderMultiChannel", "cryptomatte/1234567/name", "tiff:RowsPerStrip"})
    EXPECT_EQ(std::count(names.begin(), names.end(), gone), 0) << gone;
  EXPECT_EQ(header.lineOrder(), Imf::INCREASING_Y);
  EXPECT_EQ(header.compression(), Imf::ZIP_COMPRESSION);
  EXPECT_EQ(file.parts()[0].channels.size(), 2u);
}

TEST(WriteExr, ExistingFileStaysUnlessOverwritten) {
  const TemporaryFolder folder;
  const fs::path file = folder.path / "a.exr";
  put(file, "old");
  EXPECT_NE(refusal([&] { write(file, {}, offset_window, noise(offset_window), 59); }).find("--overwrite"), std::string::npos);
  EXPECT_EQ(contents(file), "old");
  {
    ExrWriter abandoned(file, {.overwrite = true}, {}, offset_window, offset_window, two_channels, {});
    EXPECT_EQ(names_in(folder.path).size(), 2u);
  }
  EXPECT_EQ(contents(file), "old");
  EXPECT_EQ(names_in(folder.path), std::set<std::string>{"a.exr"});
  write(file, {.overwrite = true}, offset_window, noise(offset_window), 59);
  EXPECT_EQ(read_back(file, offset_window), noise(offset_window));
  EXPECT_EQ(names_in(folder.path), std::set<std::string>{"a.exr"});
}

TEST(WriteExr, MissingRowsOrChannelsAreADefectOfTheCaller) {
  const TemporaryFolder folder;
  const std::vector<float> row(101);
  {
    ExrWriter writer(folder.path / "a.exr", {}, {}, offset_window, offset_window, two_channels, {});
    const std::vector<relume::Source> both = {{"R", row.data(), 4, 0}, {"diffuse.X", row.data(), 4, 0}};
    message_of([&] { writer.write_rows(1, {both.data(), 1}); }, ErrorKind::internal);
    writer.write_rows(58, both);
    message_of([&] { writer.write_rows(2, both); }, ErrorKind::internal);
    message_of([&] { writer.commit(); }, ErrorKind::internal);
  }
  EXPECT_TRUE(names_in(folder.path).empty());
}

/// A limit on file size makes write() fail at that byte, as a full disk does.
class SizeLimit {
 public:
  explicit SizeLimit(std::size_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{rlim_t(bytes), before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~SizeLimit() { setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  rlimit before_{};
};

TEST(WriteExr, WriteThatFailsAtAnyByteLeavesTheOldFile) {
  const TemporaryFolder folder;
  const fs::path file = folder.path / "a.exr", sample = folder.path / "sample.exr";
  const std::vector<float> pixels = noise(offset_window);
  write(sample, {}, offset_window, pixels, 59);
  const std::size_t size = std::size_t(fs::file_size(sample));
  put(file, "old");
  for (std::size_t bytes = 0; bytes < size; bytes = bytes < size - 3 && bytes + 997 >= size ? size - 1 : bytes + 997) {
    std::string message;
    {
      const SizeLimit limit(bytes);
      message = refusal([&] { write(file, {.overwrite = true}, offset_window, pixels, 5); });
    }
    EXPECT_NE(message.find("grows beyond"), std::string::npos) << message;
    ASSERT_EQ(contents(file), "old") << bytes;
    ASSERT_EQ(names_in(folder.path), (std::set<std::string>{"a.exr", "sample.exr"})) << bytes;
  }
  const SizeLimit enough(size);
  write(file, {.overwrite = true}, offset_window, pixels, 5);
  EXPECT_EQ(contents(file), contents(sample));
}

TEST(WriteExr, FullDiskLeavesTheOldFile) {
  const TemporaryFolder folder;
  const std::size_t page = std::size_t(sysconf(_SC_PAGESIZE));
  const std::vector<float> pixels = noise(offset_window);
  const auto with_disk = [&](std::size_t pages, const std::function<void(const fs::path&)>& work) {
    const std::string size = "size=" + std::to_string(pages * page);
    if (mount("tmpfs", folder.path.c_str(), "tmpfs", 0, size.c_str()) != 0) return false;
    work(folder.path);
    umount(folder.path.c_str());
    return true;
  };
  std::size_t needed = 0;
  if (!with_disk(1000, [&](const fs::path& disk) {
        write(disk / "a.exr", {}, offset_window, pixels, 59);
        needed = (std::size_t(fs::file_size(disk / "a.exr")) + page - 1) / page;
      }))
    GTEST_SKIP() << "a small disk can be made only by root";
  for (std::size_t pages = 2; pages <= needed + 1; ++pages)
    with_disk(pages, [&](const fs::path& disk) {
      put(disk / "a.exr", "old");
      const bool fits = pages == needed + 1;  // the old file has a page too
      if (fits) {
        write(disk / "a.exr", {.overwrite = true}, offset_window, pixels, 59);
        EXPECT_EQ(read_back(disk / "a.exr", offset_window), pixels);
      } else {
        EXPECT_NE(refusal([&] { write(disk / "a.exr", {.overwrite = true}, offset_window, pixels, 59); }).find("disk full"), std::string::npos);
        EXPECT_EQ(contents(disk / "a.exr"), "old");
      }
      EXPECT_EQ(names_in(disk), std::set<std::string>{"a.exr"});
    });
}

}  // namespace
