// Bands cover a window once, in order, within the memory and in whole blocks of the file.
#include "host/bands.h"

#include <gtest/gtest.h>

#include "tests/files.h"

namespace relume {
namespace {

BandLimits limits(std::int64_t rows_of_memory) {
  constexpr std::int64_t row_bytes = 1000;
  return {rows_of_memory * row_bytes, row_bytes, 1 << 20, 64 * 100, -5, 16};
}

TEST(Bands, CoverTheWindowOnceInWholeBlocks) {
  for (const Window& window : {Window{0, -5, 100, 200}, Window{3, 6, 103, 501}, Window{0, 11, 100, 12}, Window{0, 0, 100, 16}})
    for (const std::int64_t memory : {1, 7, 15, 16, 47, 48, 100, 300, 100000}) {
      const Bands bands = bands_of(window, limits(memory), "here");
      int next = window.min_y;
      for (const Window& band : bands.windows) {
        EXPECT_EQ(band.min_y, next);
        EXPECT_GT(band.height(), 0);
        EXPECT_LE(band.height() * bands.in_flight, memory) << "memory";
        const bool begins_block = (band.min_y + 5) % 16 == 0;
        EXPECT_TRUE(begins_block || memory < 16 || band.min_y == window.min_y) << "a block is decoded twice";
        next = band.max_y;
      }
      EXPECT_EQ(next, window.max_y);
      EXPECT_LE(bands.bytes, memory * 1000);
    }
}

TEST(Bands, AreAsSmallAsIsGoodAndThreeInFlight) {
  const Bands bands = bands_of({0, -5, 100, 10000}, limits(100000), "here");
  EXPECT_EQ(bands.in_flight, 3);
  EXPECT_EQ(bands.windows.front().height(), 64);
  EXPECT_EQ(bands_of({0, -5, 100, 10000}, limits(40), "here").in_flight, 1) << "three would be less than a block each";
}

TEST(Bands, NotOneRowIsAnError) {
  EXPECT_EQ(message_of([] { bands_of({0, 0, 100, 100}, limits(0), "a.exr"); }, ErrorKind::memory),
            "a.exr: one row needs 1000 bytes of planes; --memory allows 0");
}

}  // namespace
}  // namespace relume
