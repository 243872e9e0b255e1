// LightTree: halves along the longest axis of their box, until few are left; stand-ins side by side on all cores.
#include "host/light_tree.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "host/stand_ins.h"

namespace relume {
namespace {

/// Below this a tree costs more than it saves.
constexpr std::size_t too_few = 64;
/// Lights of a leaf.
constexpr int leaf = 4;

bool may_stand(const LightRecord& light) { return *std::min_element(light.intensity, light.intensity + 3) >= 0; }

/// By number; none where they are too few, or where some light takes light away: radiances would have no lower bound.
std::vector<int> lights_of_trees(const std::vector<LightRecord>& records, std::span<const int, LIGHT_COUNT + 1> begin) {
  std::vector<int> numbers;
  for (int type = 0; type < LIGHT_COUNT; ++type)
    for (int k = begin[std::size_t(type)]; k < begin[std::size_t(type) + 1]; ++k) {
      if (!may_stand(records[std::size_t(k)])) return {};
      if (LightTree::takes(records[std::size_t(k)], type)) numbers.push_back(k);
    }
  return numbers.size() < too_few ? std::vector<int>{} : numbers;
}

}  // namespace

bool LightTree::takes(const LightRecord& light, int type) { return type == LIGHT_point && light.falloff == FALLOFF_inverse_square; }

LightTree::LightTree(std::vector<LightRecord>& records, std::span<const int, LIGHT_COUNT + 1> begin) : order_(lights_of_trees(records, begin)) {
  if (order_.empty()) return;
  clusters_.emplace_back().end = int(order_.size());
  for (std::size_t c = 0; c < clusters_.size(); ++c) split(int(c), records);
  std::vector<std::vector<LightRecord>> made(clusters_.size());
  tbb::parallel_for(std::size_t(0), clusters_.size(), [&](std::size_t c) {
    LightCluster& cluster = clusters_[c];
    made[c] = find_stand_ins(cluster, records, std::span(order_).subspan(std::size_t(cluster.begin), std::size_t(cluster.end - cluster.begin)));
  });
  for (std::size_t c = 0; c < clusters_.size(); ++c) {
    clusters_[c].one.first = int(records.size());
    clusters_[c].four.first = clusters_[c].one.first + clusters_[c].one.count;
    records.insert(records.end(), made[c].begin(), made[c].end());
  }
}

/// In the middle of the box's longest axis, or at the median where that would leave nearly all on one side.
void LightTree::split(int number, std::span<const LightRecord> records) {
  const int begin = clusters_[std::size_t(number)].begin, end = clusters_[std::size_t(number)].end, count = end - begin;
  if (count <= leaf) return;
  const auto first = order_.begin() + begin, last = order_.begin() + end;
  const auto at = [&](int light, int axis) { return records[std::size_t(light)].position[axis]; };
  int axis = 0;
  float low = 0, extent = 0;
  for (int c = 0; c < 3; ++c) {
    const auto [least, most] = std::minmax_element(first, last, [&](int a, int b) { return at(a, c) < at(b, c); });
    if (at(*most, c) - at(*least, c) > extent) extent = at(*most, c) - at(*least, c), low = at(*least, c), axis = c;
  }
  if (!(extent > 0)) return;  // all in one place
  auto middle = std::partition(first, last, [&](int light) { return at(light, axis) < low + 0.5f * extent; });
  if (std::min(middle - first, last - middle) * 16 < count) {
    middle = first + count / 2;
    std::nth_element(first, middle, last, [&](int a, int b) { return at(a, axis) < at(b, axis); });
  }
  clusters_[std::size_t(number)].first_child = int(clusters_.size());
  LightCluster left, right;
  left.begin = begin, left.end = right.begin = int(middle - order_.begin()), right.end = end;
  clusters_.push_back(left);
  clusters_.push_back(right);
}

}  // namespace relume
