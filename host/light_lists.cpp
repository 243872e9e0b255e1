// LightLists: super-tiles side by side on all cores, each narrowing its parent's list.
#include "host/light_lists.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <initializer_list>

namespace relume {

/// What some blocks share.
struct LightLists::List {
  int y, column, rows, columns;  ///< the blocks that it is for
  int begin, end;                ///< in Listed::numbers
};

/// Of one super-tile.
struct LightLists::Listed {
  std::vector<List> lists;
  std::vector<int> numbers;
};

namespace {

/// With fewer lights than these the bounds cost more than the lights.
constexpr int too_few = 8;
/// Near a super-tile: as many are asked for each cell faster than for each tile first.
constexpr std::size_t few = 200;

constexpr int cells = PixelCells::tile_rows / PixelCells::cell_rows;  // in a tile, one above the other
constexpr int cut_rows = 4;  ///< of pixels that share a cut through a light tree: what holds for more of them holds for fewer clusters

/// Pixels that share a list.
enum class Sharing { cell, tile, super_tile };

using List = LightLists::List;
using Listed = LightLists::Listed;

/// What is listed of one super-tile.
class SuperTile {
 public:
  SuperTile(const PixelCells& pixels, const CellBounds& bounds, float widest_box, int number)
      : pixels_(pixels),
        bounds_(bounds),
        widest_box_(widest_box),
        y_(number / pixels.super_tiles_across() * PixelCells::super_rows),
        first_column_(number % pixels.super_tiles_across() * PixelCells::super_columns),
        end_column_(std::min(first_column_ + PixelCells::super_columns, pixels.columns())),
        end_row_(std::min((y_ + PixelCells::super_rows) / PixelCells::cell_rows, pixels.cells_down())) {}

  /// `cuts`: behind the lights that are near a cell its cut; null where there are none.
  void list(const SortedLights& lights, Sharing sharing, const LightCuts* cuts, Listed& listed) const {
    const Boxes all = boxes(y_ / PixelCells::cell_rows, end_row_, first_column_, end_column_);
    if (all.count == 0) return;
    thread_local LightReach near, nearer;
    lights.reach.members_near(all, lights.spheres, SortedLights::clustered, near);
    if (sharing == Sharing::super_tile) return add(listed, {y_, first_column_, PixelCells::super_rows, PixelCells::super_columns, 0, 0}, near, {});
    for (int row = y_ / PixelCells::cell_rows; row < end_row_; row += cells)
      for (int column = first_column_; column < end_column_; ++column) {
        const bool narrow = sharing == Sharing::tile || near.size() > few;
        if (narrow) near.near(boxes(row, std::min(row + cells, end_row_), column, column + 1), nearer);
        const LightReach& of_tile = narrow ? nearer : near;
        if (sharing == Sharing::tile)
          add(listed, {row * PixelCells::cell_rows, column, PixelCells::tile_rows, 1, 0, 0}, of_tile, {});
        else
          list_cells(row, column, of_tile, cuts, listed);
      }
  }

 private:
  /// Around the cells of rows [row, end_row) and columns [column, end_column).
  Boxes boxes(int row, int end_row, int column, int end_column) const {
    thread_local std::vector<PixelBounds> parts;
    parts.clear();
    for (; row < end_row; ++row)
      for (int c = column; c < end_column; ++c) parts.insert(parts.end(), bounds_.of(row, c).begin(), bounds_.of(row, c).end());
    return boxes_around(parts, widest_box_);
  }

  /// Those of the tile whose first row of cells is `row`.
  void list_cells(int row, int column, const LightReach& lights, const LightCuts* cuts, Listed& listed) const {
    for (const int end = std::min(row + cells, end_row_); row < end; ++row) {
      const std::span<const PixelBounds> cell = bounds_.of(row, column);
      if (cell.empty()) continue;
      const int y = row * PixelCells::cell_rows;
      if (!cuts)
        add(listed, {y, column, PixelCells::cell_rows, 1, 0, 0}, lights, cell);
      else
        for (int k = 0; k < PixelCells::cell_rows; k += cut_rows) {
          add(listed, {y + k, column, cut_rows, 1, 0, 0}, lights, cell);
          add_cut(*cuts, listed);
        }
    }
  }

  /// The lights that may light one of the parts; all of them where there are none.
  static void add(Listed& listed, List list, const LightReach& lights, std::span<const PixelBounds> parts) {
    list.begin = int(listed.numbers.size());
    if (parts.empty())
      lights.add_numbers(listed.numbers);
    else
      lights.add_lighting(parts, listed.numbers);
    list.end = int(listed.numbers.size());
    listed.lists.push_back(list);
  }

  /// To the last list.
  void add_cut(const LightCuts& cuts, Listed& listed) const {
    thread_local std::vector<PixelPatch> patches;
    patches.clear();
    List& last = listed.lists.back();
    add_patches(pixels_, last.y, last.column, last.rows, cuts.most_turn(), patches);
    cuts.add_cut(patches, listed.numbers);
    last.end = int(listed.numbers.size());
  }

  const PixelCells& pixels_;
  const CellBounds& bounds_;
  float widest_box_;
  int y_, first_column_, end_column_, end_row_;
};

/// A super-tile's lists to their place, and where they begin and end to each of their blocks.
void place(const PixelCells& pixels, const Listed& listed, int* blocks, int* numbers, int offset) {
  std::copy(listed.numbers.begin(), listed.numbers.end(), numbers + offset);
  for (const List& list : listed.lists)
    for (int y = list.y; y < list.y + list.rows; ++y)
      for (int column = list.column; column < list.column + list.columns; ++column) {
        const int block = pixels.block_at(y, column);
        if (block < 0) continue;
        blocks[2 * std::size_t(block)] = offset + list.begin;
        blocks[2 * std::size_t(block) + 1] = offset + list.end;
      }
}

/// Without those of the tree, whose numbers come cluster by cluster.
LightReach reach_without(std::span<const LightRecord> lights, std::span<const int, LIGHT_COUNT + 1> begin, const LightTree& tree) {
  std::vector<int> others(tree.order().begin(), tree.order().end());
  std::sort(others.begin(), others.end());
  return LightReach(lights, begin, others).in_space_order();
}

}  // namespace

SortedLights::SortedLights(std::span<const LightRecord> lights, std::span<const int, LIGHT_COUNT + 1> begin, const LightTree& tree)
    : reach(reach_without(lights, begin, tree)),
      spheres(reach.spheres_around(clustered)),
      widest_box(std::exp2(std::round(std::log2(0.5f * reach.median_reach())))) {}

/// Behind what there is: for each block where its list begins and ends, then the lists. Returns where that starts.
int LightLists::append(const PixelCells& pixels, const std::vector<Listed>& listed) {
  const std::size_t start = size_, blocks = 2 * std::size_t(pixels.blocks());
  std::vector<int> offsets;
  size_ += blocks;
  for (const Listed& super_tile : listed) {
    offsets.push_back(int(size_));
    size_ += super_tile.numbers.size();
  }
  if (size_ > capacity_) {
    // Megabytes that many threads write for the first time: nothing is cleared or moved before.
    std::unique_ptr<int[]> all = std::make_unique_for_overwrite<int[]>(size_);
    std::copy(numbers_.get(), numbers_.get() + start, all.get());
    numbers_ = std::move(all);
    capacity_ = size_;
  }
  int* const numbers = numbers_.get();
  std::fill_n(numbers + start, blocks, 0);
  tbb::parallel_for(std::size_t(0), listed.size(), [&](std::size_t t) { place(pixels, listed[t], numbers + start, numbers, offsets[t]); });
  return int(start);
}

int LightLists::add(FrameBounds& bounds, const SortedLights& lights, std::size_t most) {
  if (!lights.reach.any_bounded() || lights.reach.size() < too_few) return 0;
  return add_lists(bounds, lights, nullptr, most);
}

int LightLists::add(FrameBounds& bounds, const SortedLights& lights, const LightCuts& cuts, std::size_t most) {
  return add_lists(bounds, lights, &cuts, most);
}

int LightLists::add_lists(FrameBounds& frame_bounds, const SortedLights& lights, const LightCuts* cuts, std::size_t most) {
  const PixelCells& pixels = frame_bounds.pixels();
  const CellBounds& bounds = frame_bounds.split_at(lights.widest_box);
  const int count = pixels.super_tiles_across() * pixels.super_tiles_down();
  for (const Sharing sharing : {Sharing::cell, Sharing::tile, Sharing::super_tile}) {
    std::vector<Listed> listed{std::size_t(count)};
    std::atomic<std::size_t> total = size_ + 2 * std::size_t(pixels.blocks());
    tbb::parallel_for(0, count, [&](int t) {
      if (total > most) return;
      SuperTile(pixels, bounds, lights.widest_box, t).list(lights, sharing, cuts, listed[std::size_t(t)]);
      total += listed[std::size_t(t)].numbers.size();
    });
    if (total <= most) return append(pixels, listed);
    if (cuts) return 0;
  }
  return 0;
}

std::int64_t lights_met(const Frame& frame, std::span<const int> lists) {
  std::int64_t sum = frame.light_begin[LIGHT_COUNT], blocks = 1;
  if (frame.lists > 0) {
    sum = 0, blocks = (frame.pixels + PixelCells::block - 1) / PixelCells::block;
    for (std::int64_t b = 0; b < blocks; ++b) sum += lists[std::size_t(frame.lists + 2 * b + 1)] - lists[std::size_t(frame.lists + 2 * b)];
  }
  return std::max<std::int64_t>(1, blocks > 0 ? sum / blocks : 0);
}

}  // namespace relume
