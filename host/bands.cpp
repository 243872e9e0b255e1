// bands_of: as many rows as are good, in whole blocks, within the memory.
#include "host/bands.h"

#include <algorithm>

#include "gbuffer/error.h"

namespace relume {
namespace {

constexpr int stages = 3;  // decode, shade, encode: a band in each

std::int64_t rows_within(const Window& window, const BandLimits& limits, int in_flight) {
  return std::min({limits.memory / in_flight / limits.row_bytes, limits.most_rows, std::int64_t(window.height())});
}

/// A window that begins within a block begins with a shorter band, and the others with whole blocks.
int first_end(const Window& window, const BandLimits& limits, std::int64_t rows) {
  if (rows % limits.block_rows != 0 || rows == window.height()) return int(window.min_y + rows);
  return int(window.min_y + rows - (std::int64_t(window.min_y) - limits.block_top) % limits.block_rows);
}

}  // namespace

Bands bands_of(const Window& window, const BandLimits& limits, const std::string& place) {
  const std::int64_t block = limits.block_rows, good = (limits.good_pixels / window.width() + block - 1) / block * block;
  Bands bands{{}, stages, 0};
  if (rows_within(window, limits, stages) < std::min<std::int64_t>(block, window.height())) bands.in_flight = 1;
  std::int64_t rows = rows_within(window, limits, bands.in_flight);
  if (rows < 1)
    throw Error(ErrorKind::memory,
                place + ": one row needs " + std::to_string(limits.row_bytes) + " bytes of planes; --memory allows " + std::to_string(limits.memory));
  if (bands.in_flight > 1) rows = std::min(rows, std::max(good, block));
  if (rows > block && rows < window.height()) rows -= rows % block;
  bands.bytes = bands.in_flight * rows * limits.row_bytes;
  for (int top = window.min_y, end = first_end(window, limits, rows); top < window.max_y; top = end, end = int(end + rows)) {
    end = std::min(end, window.max_y);
    bands.windows.push_back({window.min_x, top, window.max_x, end});
  }
  return bands;
}

}  // namespace relume
