// CellBounds: row after row, as the planes lie in memory.
#include "host/cell_bounds.h"

#include <tbb/parallel_for.h>

namespace relume {

CellBounds::CellBounds(const PixelCells& pixels, float widest) : rows_(std::size_t(pixels.cells_down())) {
  tbb::parallel_for(0, pixels.cells_down(), [&](int row) {
    Row& made = rows_[std::size_t(row)];
    made.begin.reserve(std::size_t(pixels.columns()) + 1);
    made.parts.reserve(std::size_t(pixels.columns()) + RELUME_CELL_PARTS);
    for (int column = 0; column < pixels.columns(); ++column) {
      made.begin.push_back(made.parts.size());
      PixelBounds parts[RELUME_CELL_PARTS];
      const int count = pixels.bound(row * PixelCells::cell_rows, column, widest, parts);
      made.parts.insert(made.parts.end(), parts, parts + count);
    }
    made.begin.push_back(made.parts.size());
  });
}

}  // namespace relume
