// PixelCells: which blocks make a cell.
#include "host/pixel_cells.h"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "host/culling.h"

namespace relume {

PixelBounds no_bounds() {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  PixelBounds bounds{};
  for (int c = 0; c < 3; ++c) {
    bounds.low[c] = bounds.normal_low[c] = infinity;
    bounds.high[c] = bounds.normal_high[c] = -infinity;
  }
  return bounds;
}

void include_positions(PixelBounds& bounds, const PixelBounds& other) {
  for (int c = 0; c < 3; ++c) {
    bounds.low[c] = std::min(bounds.low[c], other.low[c]);
    bounds.high[c] = std::max(bounds.high[c], other.high[c]);
  }
}

PixelCells::PixelCells(const Planes& planes, const Frame& frame, int width)
    : planes_(planes),
      frame_(frame),
      blocks_((frame.pixels + block - 1) / block),
      rows_((frame.pixels + width - 1) / width),
      columns_((width + block - 1) / block) {
  for (std::int64_t row = 0; row <= rows_; ++row) first_of_row_.push_back(int(std::min<std::int64_t>((row * width + block - 1) / block, blocks_)));
}

int PixelCells::find_blocks(int y, int column, int* blocks) const {
  int count = 0;
  for (int row = y; row < y + cell_rows; ++row)
    if (const int number = block_at(row, column); number >= 0) blocks[count++] = number;
  return count;
}

int PixelCells::bound(int y, int column, float widest, PixelBounds* parts) const {
  int blocks[cell_rows];
  const int count = find_blocks(y, column, blocks);
  return culling().bound_cell(planes_.data(), frame_, blocks, count, widest, parts);
}

}  // namespace relume
