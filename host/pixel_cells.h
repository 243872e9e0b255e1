// A band's pixels in cells, tiles and super-tiles, and what each is bounded by.
#pragma once

#include <vector>

#include "gbuffer/planes.h"
#include "host/frame.h"

namespace relume {

PixelBounds no_bounds();
/// Makes the box of positions hold the other's too; the rest is left alone.
void include_positions(PixelBounds& bounds, const PixelBounds& other);

/// A band's pixels by lane blocks: 16 pixels that follow one another in memory, the widest that any device shades at once. Cells are up to eight rows
/// of blocks, tiles two cells, super-tiles sixteen tiles (64 x 64 pixels). A row's last block may reach into the next row: no pixel is in two.
class PixelCells {
 public:
  static constexpr int block = RELUME_LISTED_PIXELS, cell_rows = RELUME_CELL_PIXELS / block, tile_rows = 16, super_rows = 64, super_columns = 4;

  PixelCells(const Planes& planes, const Frame& frame, int width);

  const Planes& planes() const { return planes_; }
  const Frame& frame() const { return frame_; }
  int blocks() const { return blocks_; }
  int super_tiles_across() const { return (columns_ + super_columns - 1) / super_columns; }
  int super_tiles_down() const { return (rows_ + super_rows - 1) / super_rows; }
  /// Blocks whose first pixel lies in row y, at this column: its number, or -1.
  int block_at(int y, int column) const {
    if (y >= rows_) return -1;
    const int number = first_of_row_[std::size_t(y)] + column;
    return number < first_of_row_[std::size_t(y) + 1] ? number : -1;
  }
  int columns() const { return columns_; }
  int cells_down() const { return (rows_ + cell_rows - 1) / cell_rows; }
  /// Of the pixels that show a surface in the cell whose first row is y: in up to RELUME_CELL_PARTS parts, where sides are longer than `widest`.
  /// Returns how many parts there are.
  int bound(int y, int column, float widest, PixelBounds* parts) const;

 private:
  /// How many the cell has, at most cell_rows.
  int find_blocks(int y, int column, int* blocks) const;

  const Planes& planes_;
  const Frame& frame_;
  int blocks_, rows_, columns_;
  std::vector<int> first_of_row_;  ///< block, and behind the last row where it ends
};

}  // namespace relume
