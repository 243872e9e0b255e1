// LightReach: spheres, cones and half-spaces against boxes, with margins that rounding cannot cross.
#include "host/light_reach.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

// The loops over lights are compiled for each width of vector, and chosen when the program starts.
#if defined(__x86_64__)
#define RELUME_WIDE __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define RELUME_WIDE
#endif

namespace relume {
namespace {

/// The kernels compute squared distances and cosines within some 4e-7 of themselves; this is a wide berth.
constexpr float margin = 1e-4f;
constexpr float infinity = std::numeric_limits<float>::infinity();

RELUME_WIDE void near_spheres(const float* x, const float* y, const float* z, const float* range2, const PixelBounds& b, int count, int* mark) {
  for (int i = 0; i < count; ++i) {
    const float dx = std::max(std::max(b.low[0] - x[i], x[i] - b.high[0]), 0.0f);
    const float dy = std::max(std::max(b.low[1] - y[i], y[i] - b.high[1]), 0.0f);
    const float dz = std::max(std::max(b.low[2] - z[i], z[i] - b.high[2]), 0.0f);
    mark[i] = dx * dx + dy * dy + dz * dz > range2[i] ? 0 : 1;
  }
}

/// Unmarks cones that pass the sphere of `radius` around q by: the distance from a cone's side is cos(outer) across - sin(outer) along.
RELUME_WIDE void near_cones(const float* x, const float* y, const float* z, const float* ax, const float* ay, const float* az, const float* cosine,
                            const float* sine, const float* q, float radius, int count, int* mark) {
  for (int i = 0; i < count; ++i) {
    const float dx = q[0] - x[i], dy = q[1] - y[i], dz = q[2] - z[i];
    const float along = dx * ax[i] + dy * ay[i] + dz * az[i], d2 = dx * dx + dy * dy + dz * dz;
    const float across = std::sqrt(std::max(d2 - along * along, 0.0f));
    const float slack = radius + margin * (radius + std::fabs(dx) + std::fabs(dy) + std::fabs(dz));
    mark[i] = cosine[i] * across - sine[i] * along > slack ? 0 : mark[i];
  }
}

/// Unmarks lights behind every pixel: n.(light - p) = n.(light - q) - n.(p - q) is at most the sum over axes of the larger product, less the deepest
/// pixel.
RELUME_WIDE void in_front(const float* x, const float* y, const float* z, const float* w, const PixelBounds& b, float extent, int count, int* mark) {
  for (int i = 0; i < count; ++i) {
    const float dx = x[i] - w[i] * b.reference[0], dy = y[i] - w[i] * b.reference[1], dz = z[i] - w[i] * b.reference[2];
    const float most = std::max(b.normal_low[0] * dx, b.normal_high[0] * dx) + std::max(b.normal_low[1] * dy, b.normal_high[1] * dy) +
                       std::max(b.normal_low[2] * dz, b.normal_high[2] * dz);
    const float slack = margin * (std::fabs(dx) + std::fabs(dy) + std::fabs(dz) + extent);
    mark[i] = most - w[i] * b.deepest < -slack ? 0 : mark[i];
  }
}

struct Sphere {
  float centre[3], extent, radius;  ///< extent: the sum of the box's sides
};

Sphere around(const PixelBounds& b) {
  Sphere s{{0.5f * (b.low[0] + b.high[0]), 0.5f * (b.low[1] + b.high[1]), 0.5f * (b.low[2] + b.high[2])}, 0, 0};
  for (int c = 0; c < 3; ++c) s.extent += b.high[c] - b.low[c], s.radius += (b.high[c] - b.low[c]) * (b.high[c] - b.low[c]);
  s.radius = 0.5f * std::sqrt(s.radius);
  return s;
}

/// The bits of a 10-bit number, two zeros between neighbours.
std::uint32_t spread(std::uint32_t v) {
  v = (v | v << 16) & 0x030000ff;
  v = (v | v << 8) & 0x0300f00f;
  v = (v | v << 4) & 0x030c30c3;
  return (v | v << 2) & 0x09249249;
}

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
}

void LightReach::add(int light, const Values& values) {
  light_.push_back(light);
  for (int f = 0; f < fields; ++f) values_[std::size_t(f)].push_back(values[std::size_t(f)]);
  any_bounded_ |= values[range2] < infinity;
  any_cone_ |= values[cosine] != 0;
}

void LightReach::pick(const std::vector<int>& places, LightReach& kept) const {
  kept.any_bounded_ = any_bounded_, kept.any_cone_ = any_cone_;
  const auto pick_values = [&](const auto& from, auto& to) {
    to.resize(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) to[i] = from[std::size_t(places[i])];
  };
  pick_values(light_, kept.light_);
  for (std::size_t f = 0; f < std::size_t(any_cone_ ? fields : axis_x); ++f) pick_values(values_[f], kept.values_[f]);
}

void LightReach::mark_near(const PixelBounds& bounds, std::size_t first, std::size_t count, std::vector<int>& marks) const {
  const auto at = [&](int field) { return values_[std::size_t(field)].data() + first; };
  marks.resize(count);
  near_spheres(at(x), at(y), at(z), at(range2), bounds, int(count), marks.data());
  if (!any_cone_) return;
  const Sphere s = around(bounds);
  near_cones(at(x), at(y), at(z), at(axis_x), at(axis_y), at(axis_z), at(cosine), at(sine), s.centre, s.radius, int(count), marks.data());
}

void LightReach::near(const PixelBounds& bounds, LightReach& kept) const {
  thread_local std::vector<int> marks, places;
  mark_near(bounds, 0, size(), marks);
  places.resize(size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < size(); ++i) {
    places[count] = int(i);
    count += std::size_t(marks[i]);
  }
  places.resize(count);
  pick(places, kept);
}

void LightReach::add_lighting(const PixelBounds& bounds, std::vector<int>& numbers) const {
  const auto at = [&](int field) { return values_[std::size_t(field)].data(); };
  thread_local std::vector<int> marks;
  mark_near(bounds, 0, size(), marks);
  in_front(at(x), at(y), at(z), at(w), bounds, around(bounds).extent, int(size()), marks.data());
  std::size_t kept = numbers.size();
  numbers.resize(kept + size());
  for (std::size_t i = 0; i < size(); ++i) {
    numbers[kept] = light_[i];
    kept += std::size_t(marks[i]);
  }
  numbers.resize(kept);
}

/// Along Morton's curve (1966); lights that nothing bounds first, so that they spoil no neighbour's sphere.
LightReach LightReach::in_space_order() const {
  float low[3], high[3];
  for (std::size_t c = 0; c < 3; ++c) {
    const auto [least, most] = std::minmax_element(values_[c].begin(), values_[c].end());
    low[c] = size() ? *least : 0, high[c] = size() ? *most : 0;
  }
  std::vector<std::pair<std::uint32_t, int>> order(size());
  for (std::size_t i = 0; i < size(); ++i) {
    std::uint32_t code = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const float side = high[c] - low[c];
      code |= spread(side > 0 ? std::uint32_t(1023 * ((values_[c][i] - low[c]) / side)) : 0) << c;
    }
    order[i] = {values_[range2][i] < infinity ? code + 1 : 0, int(i)};
  }
  std::sort(order.begin(), order.end());
  std::vector<int> places(size());
  std::transform(order.begin(), order.end(), places.begin(), [](const auto& entry) { return entry.second; });
  LightReach ordered;
  pick(places, ordered);
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
    const Sphere s = around(box);
    const float reach = s.radius + std::sqrt(farthest);
    spheres.add(int(first) / count, {s.centre[0], s.centre[1], s.centre[2], 1, reach * reach * (1 + margin)});
  }
  return spheres;
}

void LightReach::members_near(const PixelBounds& bounds, const LightReach& spheres, int count, LightReach& kept) const {
  thread_local std::vector<int> marks, places;
  places.clear();
  spheres.near(bounds, kept);
  for (const int sphere : kept.light_) {
    const std::size_t first = std::size_t(sphere) * std::size_t(count), members = std::min(std::size_t(count), size() - first);
    mark_near(bounds, first, members, marks);
    for (std::size_t i = 0; i < members; ++i)
      if (marks[i]) places.push_back(int(first + i));
  }
  std::sort(places.begin(), places.end(), [&](int a, int b) { return light_[std::size_t(a)] < light_[std::size_t(b)]; });
  pick(places, kept);
}

}  // namespace relume
