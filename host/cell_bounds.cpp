// CellBounds: row after row, as the planes lie in memory.
#include "host/cell_bounds.h"

#include <tbb/parallel_for.h>

#include <algorithm>

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

namespace {

struct Side {
  int axis;
  float length;
};

Side longest_side(const PixelBounds& b) {
  Side longest{0, b.high[0] - b.low[0]};
  for (int c = 1; c < 3; ++c)
    if (b.high[c] - b.low[c] > longest.length) longest = {c, b.high[c] - b.low[c]};
  return longest;
}

}  // namespace

Boxes boxes_around(std::span<const PixelBounds> parts, float widest) {
  Boxes boxes;
  if (parts.empty()) return boxes;
  thread_local std::vector<int> box_of;
  box_of.assign(parts.size(), 0);
  const auto bound = [&](int box) {
    boxes.box[box] = no_bounds();
    for (std::size_t k = 0; k < parts.size(); ++k)
      if (box_of[k] == box) include_positions(boxes.box[box], parts[k]);
  };
  bound(0);
  for (boxes.count = 1; boxes.count < RELUME_CELL_PARTS; ++boxes.count) {
    const auto shorter = [](const PixelBounds& a, const PixelBounds& b) { return longest_side(a).length < longest_side(b).length; };
    const int split = int(std::max_element(boxes.box, boxes.box + boxes.count, shorter) - boxes.box);
    const PixelBounds& whole = boxes.box[split];
    const auto [axis, length] = longest_side(whole);
    // Twice the middle, of the box and of its parts.
    const float middle = whole.low[axis] + whole.high[axis];
    int moved = 0, stayed = 0;
    for (std::size_t k = 0; k < parts.size(); ++k)
      if (box_of[k] == split) ++(parts[k].low[axis] + parts[k].high[axis] > middle ? moved : stayed);
    if (!(length > widest) || moved == 0 || stayed == 0) break;
    for (std::size_t k = 0; k < parts.size(); ++k)
      if (box_of[k] == split && parts[k].low[axis] + parts[k].high[axis] > middle) box_of[k] = boxes.count;
    bound(split);
    bound(boxes.count);
  }
  return boxes;
}

}  // namespace relume
