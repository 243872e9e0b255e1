// LightReach: lights in order, and what is kept of them.
#include "host/light_reach.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>

#include "host/culling.h"
#include "host/space_order.h"

namespace relume {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// Space for numbers, held by each thread.
std::vector<int>& scratch(std::size_t size) {
  thread_local std::vector<int> numbers;
  if (numbers.size() < size) numbers.resize(size);
  return numbers;
}

constexpr int together = LightReach::together;
std::size_t padded(std::size_t count) { return (count + together - 1) / together * together; }

}  // namespace

LightReach::LightReach(std::span<const LightRecord> lights, std::span<const int, LIGHT_COUNT + 1> begin, std::span<const int> others) {
  for (int type = 0; type < LIGHT_COUNT; ++type)
    for (int k = begin[std::size_t(type)]; k < begin[std::size_t(type) + 1]; ++k) {
      if (std::binary_search(others.begin(), others.end(), k)) continue;
      const LightRecord& r = lights[std::size_t(k)];
      const bool directional = type == LIGHT_directional, spot = type == LIGHT_spot;
      const float outer = r.cone == CONE_linear ? std::cos(r.outer) : r.outer, sign = directional ? -1.0f : 1.0f;
      const float* place = directional ? r.direction : r.position;
      add(k, {sign * place[0], sign * place[1], sign * place[2], directional ? 0.0f : 1.0f, directional ? infinity : r.reach * r.reach,
              r.direction[0], r.direction[1], r.direction[2], spot ? outer : 0.0f, spot ? std::sqrt(std::max(0.0f, 1 - outer * outer)) : 0.0f});
    }
  pad();
}

void LightReach::add(int light, const Values& values) {
  light_.push_back(light);
  ++count_;
  for (int f = 0; f < fields; ++f) values_[std::size_t(f)].push_back(values[std::size_t(f)]);
  any_bounded_ |= values[range2] < infinity;
  any_cone_ |= values[cosine] != 0;
}

/// Lights of the padding reach nothing.
void LightReach::disarm_padding() { std::fill(values_[range2].begin() + std::ptrdiff_t(size()), values_[range2].end(), -1.0f); }

void LightReach::pad() {
  light_.resize(padded(size()));
  for (std::vector<float>& values : values_) values.resize(padded(size()));
  disarm_padding();
}

float LightReach::median_reach() const {
  std::vector<float> bounded;
  std::copy_if(values_[range2].begin(), values_[range2].begin() + std::ptrdiff_t(size()), std::back_inserter(bounded),
               [](float r) { return r < infinity; });
  if (bounded.empty()) return infinity;
  const auto middle = bounded.begin() + std::ptrdiff_t(bounded.size() / 2);
  std::nth_element(bounded.begin(), middle, bounded.end());
  return std::sqrt(*middle);
}

void LightReach::pick(std::span<const int> places, LightReach& kept) const {
  kept.any_bounded_ = any_bounded_, kept.any_cone_ = any_cone_;
  kept.count_ = places.size();
  const auto pick_values = [&](const auto& from, auto& to) {
    to.resize(padded(places.size()));
    for (std::size_t i = 0; i < places.size(); ++i) to[i] = from[std::size_t(places[i])];
  };
  pick_values(light_, kept.light_);
  for (std::size_t f = 0; f < std::size_t(any_cone_ ? fields : axis_x); ++f) pick_values(values_[f], kept.values_[f]);
  kept.disarm_padding();
}

LightColumns LightReach::columns() const {
  const auto at = [&](int field) { return values_[std::size_t(field)].data(); };
  return {at(x), at(y), at(z), at(w), at(range2), at(axis_x), at(axis_y), at(axis_z), at(cosine), at(sine), any_cone_};
}

void LightReach::near(std::span<const PixelBounds> boxes, LightReach& kept) const {
  std::vector<int>& places = scratch(padded(size()));
  const int count = culling().places_near(columns(), 0, int(size()), boxes.data(), int(boxes.size()), places.data());
  pick({places.data(), std::size_t(count)}, kept);
}

void LightReach::add_lighting(std::span<const PixelBounds> parts, std::vector<int>& numbers) const {
  std::vector<int>& found = scratch(padded(size()));
  const int count = culling().numbers_lighting(columns(), int(size()), parts.data(), int(parts.size()), light_.data(), found.data());
  numbers.insert(numbers.end(), found.begin(), found.begin() + count);
}

/// Lights that nothing bounds first, so that they spoil no neighbour's sphere.
LightReach LightReach::in_space_order() const {
  const auto positions = [&](std::size_t axis) { return std::span(values_[axis]).first(size()); };
  const std::vector<std::uint32_t> places_along = places_on_curve(positions(x), positions(y), positions(z));
  std::vector<std::pair<std::uint32_t, int>> order(size());
  for (std::size_t i = 0; i < size(); ++i) order[i] = {values_[range2][i] < infinity ? places_along[i] + 1 : 0, int(i)};
  std::sort(order.begin(), order.end());
  std::vector<int> places(size());
  std::transform(order.begin(), order.end(), places.begin(), [](const auto& entry) { return entry.second; });
  LightReach ordered;
  pick(places, ordered);
  for (std::size_t i = 0; i < size(); ++i) {
    const std::size_t number = std::size_t(ordered.light_[i]);
    if (ordered.place_of_.size() <= number) ordered.place_of_.resize(number + 1);
    ordered.place_of_[number] = int(i);
  }
  return ordered;
}

LightReach LightReach::spheres_around(int count) const {
  LightReach spheres;
  for (std::size_t first = 0; first < size(); first += std::size_t(count)) {
    const std::size_t last = std::min(first + std::size_t(count), size());
    PixelBounds box = no_bounds();
    float farthest = 0;
    for (std::size_t i = first; i < last; ++i) {
      for (std::size_t c = 0; c < 3; ++c) box.low[c] = std::min(box.low[c], values_[c][i]), box.high[c] = std::max(box.high[c], values_[c][i]);
      farthest = std::max(farthest, values_[range2][i]);
    }
    Values sphere{};
    float diagonal2 = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      sphere[c] = 0.5f * (box.low[c] + box.high[c]);
      diagonal2 += (box.high[c] - box.low[c]) * (box.high[c] - box.low[c]);
    }
    const float reach = 0.5f * std::sqrt(diagonal2) + std::sqrt(farthest);
    sphere[w] = 1, sphere[range2] = reach * reach * (1 + reach_margin);
    spheres.add(int(first) / count, sphere);
  }
  spheres.pad();
  return spheres;
}

void LightReach::members_near(std::span<const PixelBounds> boxes, const LightReach& spheres, int count, LightReach& kept) const {
  thread_local std::vector<int> near_spheres, places;
  thread_local std::vector<std::uint64_t> is_near;  // a bit for each light, by number: all 0 between calls
  near_spheres.resize(padded(spheres.size()));
  const int near_count = culling().places_near(spheres.columns(), 0, int(spheres.size()), boxes.data(), int(boxes.size()), near_spheres.data());
  places.resize(std::size_t(near_count) * std::size_t(count));
  int found = 0;
  for (int k = 0; k < near_count; ++k) {
    const int first = near_spheres[std::size_t(k)] * count, last = std::min(first + count, int(size()));
    found += culling().places_near(columns(), first, last, boxes.data(), int(boxes.size()), places.data() + found);
  }
  is_near.resize(std::max(is_near.size(), place_of_.size() / 64 + 1));
  for (int k = 0; k < found; ++k) {
    const unsigned number = unsigned(light_[std::size_t(places[std::size_t(k)])]);
    is_near[number / 64] |= std::uint64_t(1) << number % 64;
  }
  found = 0;
  for (std::size_t word = 0; word <= place_of_.size() / 64; ++word)
    for (; is_near[word]; is_near[word] &= is_near[word] - 1)
      places[std::size_t(found++)] = place_of_[64 * word + std::size_t(std::countr_zero(is_near[word]))];
  pick({places.data(), std::size_t(found)}, kept);
}

}  // namespace relume
