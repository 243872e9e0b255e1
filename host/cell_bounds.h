// What bounds each cell of a band: asked of lights in place of its pixels.
#pragma once

#include <span>
#include <vector>

#include "host/pixel_cells.h"

namespace relume {

class CellBounds {
 public:
  /// Boxes with sides longer than `widest` are split, so that a step in depth is bounded on either side of it.
  CellBounds(const PixelCells& pixels, float widest);

  /// Of the cell of this row of cells: its parts, none where it shows no surface.
  std::span<const PixelBounds> of(int row, int column) const {
    const Row& r = rows_[std::size_t(row)];
    return std::span(r.parts).subspan(r.begin[std::size_t(column)], r.begin[std::size_t(column) + 1] - r.begin[std::size_t(column)]);
  }

 private:
  struct Row {
    std::vector<PixelBounds> parts;
    std::vector<std::size_t> begin;  ///< of each column's parts, and their end
  };
  std::vector<Row> rows_;
};

/// Boxes around positions: one around all, or up to RELUME_CELL_PARTS where it would be wide.
struct Boxes {
  PixelBounds box[RELUME_CELL_PARTS];
  int count = 0;

  operator std::span<const PixelBounds>() const { return {box, std::size_t(count)}; }
};

/// Around the positions of all parts; with a side longer than `widest`, split in its middle.
Boxes boxes_around(std::span<const PixelBounds> parts, float widest);

}  // namespace relume
