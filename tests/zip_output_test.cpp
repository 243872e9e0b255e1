// What we pack by ZIP and ZIPS, OpenEXR reads: every pixel, in bands of any height, with long names, into rows that end within a block.
#include "gbuffer/zip_output.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfInputFile.h>
#include <half.h>

#include <cmath>

#include "tests/files.h"

namespace relume {
namespace {

constexpr Window window{-20, 7, 81, 66};  // 101 x 59: the last block has 11 rows

/// Smooth here, noise there: some blocks pack well, others not at all.
float value_at(int x, int y, int channel) { return x < 0 ? float(y + channel) : std::sin(float(x * 7919 + y * 104729 + channel)) * 1e3f; }

std::vector<std::vector<float>> planes_of(int channels) {
  std::vector<std::vector<float>> planes;
  for (int c = 0; c < channels; ++c) {
    planes.emplace_back();
    for (int y = window.min_y; y < window.max_y; ++y)
      for (int x = window.min_x; x < window.max_x; ++x) planes.back().push_back(value_at(x, y, c));
  }
  return planes;
}

const std::vector<std::string> names{"R", "a layer whose name is longer than 31 letters.X", "B"};

class ZipOutputs : public testing::TestWithParam<std::tuple<const char*, SampleType, int>> {};

TEST_P(ZipOutputs, AreReadByOpenExr) {
  const auto [compression, type, band] = GetParam();
  const TemporaryFolder folder;
  const std::vector<std::vector<float>> planes = planes_of(3);
  {
    ExrWriter writer(folder.path / "a.exr", {type, compression, false}, {}, window, {0, 0, 64, 64}, names, {});
    for (int y = 0; y < window.height(); y += band) {
      std::vector<Source> sources;
      for (std::size_t c = 0; c < 3; ++c)
        sources.push_back({names[c], planes[c].data() + y * window.width(), sizeof(float), sizeof(float) * std::size_t(window.width())});
      writer.write_rows(std::min(band, window.height() - y), sources);
    }
    writer.commit();
  }
  Imf::InputFile file((folder.path / "a.exr").c_str());
  ASSERT_TRUE(file.isComplete());
  EXPECT_EQ(file.header().dataWindow(), Imath::Box2i({window.min_x, window.min_y}, {window.max_x - 1, window.max_y - 1}));
  for (std::size_t c = 0; c < 3; ++c) {
    ASSERT_EQ(file.header().channels()[names[c]].type, type == SampleType::half_float ? Imf::HALF : Imf::FLOAT);
    std::vector<float> read(planes[c].size());
    Imf::FrameBuffer frame;
    frame.insert(names[c], Imf::Slice::Make(Imf::FLOAT, read.data(), {window.min_x, window.min_y}, window.width(), window.height()));
    file.setFrameBuffer(frame);
    file.readPixels(window.min_y, window.max_y - 1);
    for (std::size_t i = 0; i < read.size(); ++i)
      ASSERT_EQ(read[i], type == SampleType::half_float ? float(half(planes[c][i])) : planes[c][i]) << names[c] << ' ' << i;
  }
}

INSTANTIATE_TEST_SUITE_P(All, ZipOutputs,
                         testing::Combine(testing::Values("zip", "zips"), testing::Values(SampleType::half_float, SampleType::float32),
                                          testing::Values(1, 5, 16, 40, 59)));

}  // namespace
}  // namespace relume
