// sample_rows: enough of a frame to decide by, and never more than a little, whatever the frame's shape.
#include "gbuffer/sample_rows.h"

#include <gtest/gtest.h>

#include "tests/make_gbuffer.h"
#include "tests/run_program.h"

namespace relume {
namespace {

void expect_samples(int width, int height) {
  const TemporaryFolder folder;
  MadeUpGBuffer made = MadeUpGBuffer::of_size(width, height);
  made.data.min_x = -5;
  made.data.max_x -= 5;
  made.channels = {"P.X", "P.Y", "P.Z", "N.X", "N.Y", "N.Z"};
  write_gbuffer(folder / "g.exr", made);
  const ExrFile file(folder / "g.exr");
  ReadingOptions options;
  options.camera = Camera{};
  const Reading reading = understand(file, options);
  std::int64_t pixels = 0;
  for (const SampledBand& band : sample_rows(file, reading, {"position"})) {
    pixels += band.window.pixels();
    ASSERT_EQ(band.planes.at("position").size(), std::size_t(3 * band.window.pixels()));
    EXPECT_GE(band.window.min_x, made.data.min_x);
    EXPECT_LE(band.window.max_x, made.data.max_x);
    EXPECT_LE(band.window.max_y, made.data.max_y);
    const int x = band.window.min_x + band.window.width() / 2, y = band.window.max_y - 1;
    const glm::dvec3 expected = scene_at(made, x, y).position,
                     read = band.vector("position", band.index(x - band.window.min_x, y - band.window.min_y));
    EXPECT_NEAR(glm::length(read - expected), 0, 1e-4) << "values belong to other pixels than they say";
  }
  EXPECT_GE(pixels, std::min<std::int64_t>(std::int64_t(width) * height, 1 << 16));
  EXPECT_LE(pixels, 4 << 17);
}

TEST(SampleRows, OrdinaryFramesInRows) {
  expect_samples(64, 64);
  expect_samples(1920, 200);
}

TEST(SampleRows, FramesTooWideForARowInPieces) {
  expect_samples(200000, 3);
  expect_samples(60000, 12);
}

TEST(SampleRows, TallFrames) { expect_samples(3, 60000); }

}  // namespace
}  // namespace relume
