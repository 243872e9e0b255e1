// PixelCells: which blocks make a cell.
#include "host/pixel_cells.h"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "host/twin.h"

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
      width_(width),
      blocks_((frame.pixels + block - 1) / block),
      rows_((frame.pixels + width - 1) / width),
      columns_((width + block - 1) / block) {}

int PixelCells::block_at(int y, int column) const {
  const auto first_of_row = [&](int row) { return std::min<std::int64_t>((std::int64_t(row) * width_ + block - 1) / block, blocks_); };
  const std::int64_t number = first_of_row(y) + column;
  return y < rows_ && number < first_of_row(y + 1) ? int(number) : -1;
}

std::vector<int> PixelCells::blocks_of_cell(int y, int column) const {
  int blocks[cell_rows];
  return {blocks, blocks + find_blocks(y, column, blocks)};
}

int PixelCells::find_blocks(int y, int column, int* blocks) const {
  int count = 0;
  for (int row = y; row < y + cell_rows; ++row)
    if (const int number = block_at(row, column); number >= 0) blocks[count++] = number;
  return count;
}

PixelBounds PixelCells::bounds_of_cell(int y, int column) const {
  int blocks[cell_rows];
  const int count = find_blocks(y, column, blocks);
  PixelBounds bounds = no_bounds();
  const float* const program = planes_.plane(frame_.program_plane);
  for (int k = 0; k < count; ++k)
    for (int i = blocks[k] * block, last = std::min(i + block, frame_.pixels); i < last; ++i) {
      if (program[i] < 0) continue;
      for (int c = 0; c < 3; ++c) bounds.reference[c] = planes_.plane(frame_.position + c)[i];
      bound_cell(planes_.data(), frame_, blocks, count, bounds);
      return bounds;
    }
  return bounds;
}

}  // namespace relume
