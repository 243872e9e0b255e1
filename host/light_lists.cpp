// LightLists: super-tiles side by side on all cores, each narrowing its parent's list.
#include "host/light_lists.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <initializer_list>

#include "host/pixel_cells.h"

namespace relume {
namespace {

/// With fewer lights than these the bounds cost more than the lights.
constexpr int too_few = 8;

constexpr int tiles = PixelCells::super_rows / PixelCells::tile_rows, cells = PixelCells::tile_rows / PixelCells::cell_rows;

/// Pixels that share a list.
enum class Sharing { cell, tile, super_tile };

struct List {
  int y, column, rows, columns;  ///< the blocks that it is for
  int begin, end;                ///< in Listed::numbers
};

struct Listed {
  std::vector<List> lists;
  std::vector<int> numbers;
};

/// What is listed of one super-tile.
class SuperTile {
 public:
  SuperTile(const PixelCells& pixels, int number)
      : y_(number / pixels.super_tiles_across() * PixelCells::super_rows), column_(number % pixels.super_tiles_across() * PixelCells::super_columns) {
    for (int t = 0; t < tiles; ++t)
      for (int c = 0; c < PixelCells::super_columns; ++c)
        for (int k = 0; k < cells; ++k) {
          if (k == 0) tile_[t][c] = no_bounds();
          cell_[t][c][k] = pixels.bounds_of_cell(y_of(t, k), column_ + c);
          include_positions(tile_[t][c], cell_[t][c][k]);
          include_positions(all_, cell_[t][c][k]);
        }
  }

  /// Once more for tiles, each with its cut behind the lights that are near it.
  void list(const PixelCells& pixels, const SortedLights& lights, const LightCuts& cuts, Listed& listed) const {
    if (is_empty(all_)) return;
    thread_local LightReach near, nearer;
    thread_local std::vector<PixelPatch> patches;
    lights.reach.members_near(all_, lights.spheres, SortedLights::clustered, near);
    for (int t = 0; t < tiles; ++t)
      for (int c = 0; c < PixelCells::super_columns; ++c) {
        if (is_empty(tile_[t][c])) continue;
        near.near(tile_[t][c], nearer);
        for (int k = 0; k < cells; ++k) {
          if (is_empty(cell_[t][c][k])) continue;
          add(listed, {y_of(t, k), column_ + c, PixelCells::cell_rows, 1, 0, 0}, nearer, cell_[t][c][k], true);
          patches.clear();
          add_patches(pixels, y_of(t, k), column_ + c, PixelCells::cell_rows, cuts.most_turn(), patches);
          cuts.add_cut(patches, listed.numbers);
          listed.lists.back().end = int(listed.numbers.size());
        }
      }
  }

  void list(const SortedLights& lights, Sharing sharing, Listed& listed) const {
    if (is_empty(all_)) return;
    thread_local LightReach near, nearer;
    lights.reach.members_near(all_, lights.spheres, SortedLights::clustered, near);
    if (sharing == Sharing::super_tile) return add(listed, {y_, column_, PixelCells::super_rows, PixelCells::super_columns, 0, 0}, near, all_, false);
    for (int t = 0; t < tiles; ++t)
      for (int c = 0; c < PixelCells::super_columns; ++c) {
        if (is_empty(tile_[t][c])) continue;
        near.near(tile_[t][c], nearer);
        if (sharing == Sharing::tile) {
          add(listed, {y_of(t, 0), column_ + c, PixelCells::tile_rows, 1, 0, 0}, nearer, tile_[t][c], false);
          continue;
        }
        for (int k = 0; k < cells; ++k)
          if (!is_empty(cell_[t][c][k])) add(listed, {y_of(t, k), column_ + c, PixelCells::cell_rows, 1, 0, 0}, nearer, cell_[t][c][k], true);
      }
  }

 private:
  int y_of(int tile, int cell) const { return y_ + tile * PixelCells::tile_rows + cell * PixelCells::cell_rows; }
  static void add(Listed& listed, List list, const LightReach& lights, const PixelBounds& bounds, bool facing) {
    list.begin = int(listed.numbers.size());
    if (facing)
      lights.add_lighting(bounds, listed.numbers);
    else
      lights.add_numbers(listed.numbers);
    list.end = int(listed.numbers.size());
    listed.lists.push_back(list);
  }

  int y_, column_;
  PixelBounds all_ = no_bounds(), tile_[tiles][PixelCells::super_columns], cell_[tiles][PixelCells::super_columns][cells];
};

/// A super-tile's lists to their place, and where they begin and end to each of their blocks.
void place(const PixelCells& pixels, const Listed& listed, int* blocks, int* numbers, int offset) {
  std::copy(listed.numbers.begin(), listed.numbers.end(), numbers + offset);
  for (const List& list : listed.lists)
    for (int y = list.y; y < list.y + list.rows; ++y)
      for (int column = list.column; column < list.column + list.columns; ++column) {
        const int block = pixels.block_at(y, column);
        if (block < 0) continue;
        blocks[2 * block] = offset + list.begin;
        blocks[2 * block + 1] = offset + list.end;
      }
}

/// Behind the `count` numbers: for each block where its list begins and ends, then the lists. Returns where that starts.
int append(const PixelCells& pixels, const std::vector<Listed>& listed, std::unique_ptr<int[]>& numbers, std::size_t& count) {
  const std::size_t start = count, blocks = 2 * std::size_t(pixels.blocks());
  std::vector<int> offsets;
  std::size_t size = start + blocks;
  for (const Listed& super_tile : listed) {
    offsets.push_back(int(size));
    size += super_tile.numbers.size();
  }
  // Megabytes that many threads write for the first time: nothing is cleared or moved before.
  std::unique_ptr<int[]> all = std::make_unique_for_overwrite<int[]>(size);
  std::copy(numbers.get(), numbers.get() + start, all.get());
  std::fill_n(all.get() + start, blocks, 0);
  tbb::parallel_for(std::size_t(0), listed.size(), [&](std::size_t t) { place(pixels, listed[t], all.get() + start, all.get(), offsets[t]); });
  numbers = std::move(all);
  count = size;
  return int(start);
}

/// Without those of the tree, whose numbers come cluster by cluster.
LightReach reach_without(std::span<const LightRecord> lights, std::span<const int, LIGHT_COUNT + 1> begin, const LightTree& tree) {
  std::vector<int> others(tree.order().begin(), tree.order().end());
  std::sort(others.begin(), others.end());
  return LightReach(lights, begin, others).in_space_order();
}

}  // namespace

SortedLights::SortedLights(std::span<const LightRecord> lights, std::span<const int, LIGHT_COUNT + 1> begin, const LightTree& tree)
    : reach(reach_without(lights, begin, tree)), spheres(reach.spheres_around(clustered)) {}

int LightLists::add(const Planes& planes, const Frame& frame, int width, const SortedLights& lights, std::size_t most) {
  if (!lights.reach.any_bounded() || lights.reach.size() < too_few) return 0;
  return add_lists(planes, frame, width, lights, nullptr, most);
}

int LightLists::add(const Planes& planes, const Frame& frame, int width, const SortedLights& lights, const LightCuts& cuts, std::size_t most) {
  return add_lists(planes, frame, width, lights, &cuts, most);
}

int LightLists::add_lists(const Planes& planes, const Frame& frame, int width, const SortedLights& lights, const LightCuts* cuts, std::size_t most) {
  const PixelCells pixels(planes, frame, width);
  const int count = pixels.super_tiles_across() * pixels.super_tiles_down();
  for (const Sharing sharing : {Sharing::cell, Sharing::tile, Sharing::super_tile}) {
    std::vector<Listed> listed{std::size_t(count)};
    std::atomic<std::size_t> total = size_ + 2 * std::size_t(pixels.blocks());
    tbb::parallel_for(0, count, [&](int t) {
      if (total > most) return;
      if (cuts)
        SuperTile(pixels, t).list(pixels, lights, *cuts, listed[std::size_t(t)]);
      else
        SuperTile(pixels, t).list(lights, sharing, listed[std::size_t(t)]);
      total += listed[std::size_t(t)].numbers.size();
    });
    if (total <= most) return append(pixels, listed, numbers_, size_);
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
