// median_cut: the region with most energy is halved until there are enough; for a power of two that is Debevec's cut, level by level.
#include "host/median_cut.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <queue>
#include <utility>

namespace relume {
namespace {

/// The paper's weights (ITU-R BT.709).
double luminance(const std::array<float, 3>& radiance) { return 0.2125 * radiance[0] + 0.7154 * radiance[1] + 0.0721 * radiance[2]; }

/// Texels [left, right) of rows [top, bottom).
struct Region {
  int left, top, right, bottom;
  double energy;

  bool operator<(const Region& other) const { return energy < other.energy; }
  int texels() const { return (right - left) * (bottom - top); }
};

class Cutter {
 public:
  explicit Cutter(const EnvironmentMap& map)
      : map_(map), solid_angles_(map.solid_angles()), sums_(std::size_t(map.width + 1) * std::size_t(map.height + 1)) {
    for (int i = 0; i < map.height; ++i) {
      double row = 0;
      for (int j = 0; j < map.width; ++j) {
        row += luminance(texel(i, j)) * solid_angles_[std::size_t(i)];
        sum(i + 1, j + 1) = sum(i, j + 1) + row;
      }
    }
  }

  Region all() { return region(0, 0, map_.width, map_.height); }

  /// Across its longer side on the sphere, where each half has half of the energy, as near as texels allow.
  std::pair<Region, Region> halves(const Region& r) {
    const double middle = 0.5 * (map_.polar_angle(r.top) + map_.polar_angle(r.bottom - 1));
    const double across = 2 * std::numbers::pi / map_.width * (r.right - r.left) * std::sin(middle);
    const double down = std::numbers::pi / map_.row_steps() * (r.bottom - r.top);
    const bool upright = r.right - r.left > 1 && (across >= down || r.bottom - r.top == 1);
    const auto first_part = [&](int at) { return upright ? region(r.left, r.top, at, r.bottom) : region(r.left, r.top, r.right, at); };
    int low = (upright ? r.left : r.top) + 1, high = (upright ? r.right : r.bottom) - 1;  // each half has a texel at least
    while (low < high) {
      const int at = (low + high) / 2;
      if (first_part(at).energy < 0.5 * r.energy)
        low = at + 1;
      else
        high = at;
    }
    const int least = (upright ? r.left : r.top) + 1;
    if (low > least && 0.5 * r.energy - first_part(low - 1).energy < first_part(low).energy - 0.5 * r.energy) --low;
    return {first_part(low), upright ? region(low, r.top, r.right, r.bottom) : region(r.left, low, r.right, r.bottom)};
  }

  /// All of the region's light, from the mean of its directions by energy.
  DirectedIrradiance light(const Region& r) const {
    DirectedIrradiance light{glm::dvec3(0), glm::dvec3(0)};
    for (int i = r.top; i < r.bottom; ++i)
      for (int j = r.left; j < r.right; ++j) {
        const std::array<float, 3>& radiance = texel(i, j);
        light.irradiance += solid_angles_[std::size_t(i)] * glm::dvec3(radiance[0], radiance[1], radiance[2]);
        light.direction += solid_angles_[std::size_t(i)] * luminance(radiance) * map_.direction(i, j);
      }
    // Light from all around has no mean direction; any will do.
    light.direction = glm::length(light.direction) > 0 ? glm::normalize(light.direction) : map_.direction(r.top, r.left);
    return light;
  }

 private:
  const std::array<float, 3>& texel(int i, int j) const { return map_.radiance[std::size_t(i) * std::size_t(map_.width) + std::size_t(j)]; }
  double& sum(int i, int j) { return sums_[std::size_t(i) * std::size_t(map_.width + 1) + std::size_t(j)]; }
  Region region(int left, int top, int right, int bottom) {
    return {left, top, right, bottom, sum(bottom, right) - sum(top, right) - sum(bottom, left) + sum(top, left)};
  }

  const EnvironmentMap& map_;
  std::vector<double> solid_angles_, sums_;  ///< sums_: energy above and left of a corner (a summed-area table, Crow 1984)
};

}  // namespace

std::vector<DirectedIrradiance> median_cut(const EnvironmentMap& map, int lights) {
  Cutter cutter(map);
  std::priority_queue<Region> regions;
  std::vector<Region> whole;  // single texels
  const auto keep = [&](const Region& r) { r.texels() > 1 ? regions.push(r) : whole.push_back(r); };
  keep(cutter.all());
  while (!regions.empty() && int(regions.size() + whole.size()) < lights) {
    const auto [one, other] = cutter.halves(regions.top());
    regions.pop();
    keep(one);
    keep(other);
  }
  for (; !regions.empty(); regions.pop()) whole.push_back(regions.top());
  std::vector<DirectedIrradiance> all;
  for (const Region& r : whole)
    if (const DirectedIrradiance light = cutter.light(r); light.irradiance != glm::dvec3(0)) all.push_back(light);
  return all;
}

}  // namespace relume
