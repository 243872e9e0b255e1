// ZIP blocks against OpenEXR: what it packs we unpack to the same bits, whatever they are, and what is damaged is refused. Half floats against Imath.
#include "gbuffer/zip_block.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfOutputFile.h>

#include <bit>
#include <cstring>
#include <random>

#include "gbuffer/exr_file.h"
#include "gbuffer/half_floats.h"
#include "tests/files.h"

namespace relume {
namespace {

std::vector<char> random_bytes(std::size_t count, unsigned seed, int values) {
  std::mt19937 random(seed);
  std::vector<char> bytes(count);
  for (char& byte : bytes) byte = char(random() % unsigned(values));
  return bytes;
}

TEST(ZipBlock, ComesBack) {
  ZipPacker packer;
  ZipUnpacker unpacker;
  for (const std::size_t bytes : {4u, 30u, 32u, 34u, 62u, 66u, 1000u, 65538u})
    for (const int values : {1, 3, 256}) {  // 256: packing makes it no smaller
      const std::vector<char> block = random_bytes(bytes, unsigned(bytes), values);
      unpacker.unpack(packer.pack(block), bytes);
      std::vector<char> back(bytes);
      unpacker.take(0, bytes, back.data());
      EXPECT_EQ(back, block) << bytes << " bytes of " << values << " values";
      std::vector<char> part(bytes / 2 & ~std::size_t(1));
      unpacker.take(bytes - part.size(), part.size(), part.data());
      EXPECT_TRUE(std::equal(part.begin(), part.end(), block.end() - std::ptrdiff_t(part.size()))) << bytes;
    }
}

TEST(ZipBlock, OfAnotherLengthOrDamagedIsRefused) {
  ZipPacker packer;
  ZipUnpacker unpacker;
  const std::vector<char> block = random_bytes(1000, 1, 4);
  const std::span<const char> packed = packer.pack(block);
  ASSERT_LT(packed.size(), 900u);
  EXPECT_THROW(unpacker.unpack(packed, 998), std::runtime_error);
  EXPECT_THROW(unpacker.unpack(packed, 1002), std::runtime_error);
  EXPECT_THROW(unpacker.unpack(packed.first(packed.size() / 2), 1000), std::runtime_error);
  EXPECT_THROW(unpacker.unpack({}, 1000), std::runtime_error);
  std::vector<char> damaged(packed.begin(), packed.end());
  damaged[damaged.size() / 2] ^= 1;
  EXPECT_THROW(unpacker.unpack(damaged, 1000), std::runtime_error) << "the checksum";
}

constexpr Window data{-5, 3, 38, 58};
constexpr std::pair<const char*, SampleType> channels[] = {{"a", SampleType::half_float}, {"b", SampleType::float32}, {"c", SampleType::uint32}};

std::size_t bytes_of(SampleType type) { return type == SampleType::half_float ? 2 : 4; }

/// Written by OpenEXR; the planes of the channels.
std::vector<std::vector<char>> write_random(const std::filesystem::path& file, Imf::Compression compression, int values) {
  std::vector<std::vector<char>> planes;
  Imf::Header header({{0, 0}, {63, 63}}, {{data.min_x, data.min_y}, {data.max_x - 1, data.max_y - 1}});
  header.compression() = compression;
  header.lineOrder() = values == 3 ? Imf::DECREASING_Y : Imf::INCREASING_Y;
  Imf::FrameBuffer frame;
  for (const auto& [name, type] : channels) {
    const Imf::PixelType stored = type == SampleType::half_float ? Imf::HALF : type == SampleType::float32 ? Imf::FLOAT : Imf::UINT;
    planes.push_back(random_bytes(std::size_t(data.pixels()) * bytes_of(type), unsigned(planes.size()), values));
    header.channels().insert(name, Imf::Channel(stored));
    frame.insert(name, Imf::Slice::Make(stored, planes.back().data(), {data.min_x, data.min_y}, data.width(), data.height()));
  }
  Imf::OutputFile out(file.c_str(), header);
  out.setFrameBuffer(frame);
  out.writePixels(data.height());
  return planes;
}

void expect_same_bits(const ExrFile& file, const Window& window, const std::pair<const char*, SampleType>& channel, const std::vector<char>& plane) {
  const std::size_t bytes = bytes_of(channel.second), step = bytes * 3;
  std::vector<char> read(std::size_t(window.pixels()) * step);
  const Destination to{channel.first, channel.second, read.data(), step, step * std::size_t(window.width())};
  file.read(0, window, {&to, 1});
  const char* next = read.data();
  for (int y = window.min_y; y < window.max_y; ++y)
    for (int x = window.min_x; x < window.max_x; ++x, next += step) {
      const std::size_t from = std::size_t(y - data.min_y) * std::size_t(data.width()) + std::size_t(x - data.min_x);
      ASSERT_EQ(std::memcmp(next, &plane[from * bytes], bytes), 0) << channel.first << ' ' << x << ' ' << y;
    }
}

/// Bits of every kind, NaN among them, in channels of every type, read in windows of every alignment.
class ZipFile : public testing::TestWithParam<std::tuple<Imf::Compression, int>> {};

TEST_P(ZipFile, IsReadToTheSameBits) {
  const auto [compression, values] = GetParam();
  const TemporaryFolder folder;
  const std::vector<std::vector<char>> planes = write_random(folder.path / "a.exr", compression, values);
  const ExrFile file(folder.path / "a.exr");
  for (const Window& window : {data, Window{-5, 19, 38, 20}, Window{-4, 4, 31, 51}, Window{37, 57, 38, 58}})
    for (std::size_t c = 0; c < 3; ++c) expect_same_bits(file, window, channels[c], planes[c]);
}

INSTANTIATE_TEST_SUITE_P(Codecs, ZipFile, testing::Combine(testing::Values(Imf::ZIP_COMPRESSION, Imf::ZIPS_COMPRESSION), testing::Values(2, 3, 256)));

bool same(float a, float b) { return std::isnan(a) ? std::isnan(b) : std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b); }

TEST(HalfFloats, AreImaths) {
  std::vector<half> halves(1 << 16);
  for (std::size_t i = 0; i < halves.size(); ++i) halves[i].setBits(static_cast<unsigned short>(i));
  std::vector<float> floats(halves.size());
  floats_of(halves.data() + 3, floats.data() + 3, halves.size() - 3);
  floats_of(halves.data(), floats.data(), 3);  // fewer than the processor's eight
  for (std::size_t i = 0; i < halves.size(); ++i) ASSERT_TRUE(same(floats[i], halves[i])) << i;

  std::mt19937 random(1);
  for (float& value : floats) value = std::bit_cast<float>(std::uint32_t(random()));
  for (std::size_t i = 0; i < 4096; ++i) floats[i] = float(half(float(i) / 64)) + 0x1p-6f / 64;  // between two halves, some right in the middle
  floats.back() = INFINITY, floats[4096] = -INFINITY, floats[4097] = 1e30f;
  halves_of(floats.data(), halves.data(), floats.size());
  for (std::size_t i = 0; i < halves.size(); ++i) {
    const float in_range = std::isfinite(floats[i]) ? std::clamp(floats[i], -65504.0f, 65504.0f) : floats[i];
    ASSERT_TRUE(same(halves[i], half(in_range))) << floats[i];
  }
}

}  // namespace
}  // namespace relume
