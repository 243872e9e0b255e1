// Boxes of positions against spheres (Arvo 1990, "A Simple Method for Box-Sphere Intersection Testing"), a tile at a time.
#include "bench/tile_statistics.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace relume::bench {
namespace {

constexpr int side = 16;  // pixels, the size that ISPC's example culls by

struct Tile {
  std::vector<glm::vec3> positions;
  glm::vec3 low{1e30f}, high{-1e30f};
};

Tile tile_at(const GBuffer& frame, int tile_x, int tile_y) {
  Tile tile;
  const int width = frame.window.width(), height = frame.window.height();
  for (int y = tile_y * side; y < std::min((tile_y + 1) * side, height); ++y)
    for (int x = tile_x * side; x < std::min((tile_x + 1) * side, width); ++x) {
      const std::size_t i = std::size_t(y) * std::size_t(width) + std::size_t(x);
      if (frame.planes.plane(frame.coverage.first)[i] <= 0) continue;
      const auto component = [&](int c) { return frame.planes.plane(frame.position.first + c)[i]; };
      tile.positions.emplace_back(component(0), component(1), component(2));
      tile.low = glm::min(tile.low, tile.positions.back());
      tile.high = glm::max(tile.high, tile.positions.back());
    }
  return tile;
}

struct Sums {
  double brute = 0, culled = 0, in_range = 0, tiles = 0, tile_lights = 0, most = 0;
};

void add_tile(const Tile& tile, const std::vector<Light>& lights, Sums& sums) {
  if (tile.positions.empty()) return;
  double left = 0;
  for (const Light& light : lights) {
    const glm::vec3 centre(light.position), nearest = glm::clamp(centre, tile.low, tile.high);
    const float range2 = float(light.range * light.range);
    const auto within = [&](const glm::vec3& p) { return glm::dot(p - centre, p - centre) < range2; };
    if (!within(nearest)) continue;
    ++left;
    sums.in_range += double(std::count_if(tile.positions.begin(), tile.positions.end(), within));
  }
  sums.brute += double(tile.positions.size()) * double(lights.size());
  sums.culled += double(tile.positions.size()) * left;
  sums.tiles += 1;
  sums.tile_lights += left;
  sums.most = std::max(sums.most, left);
}

}  // namespace

TileStatistics tile_statistics(const GBuffer& frame, const std::vector<Light>& lights) {
  const int columns = (frame.window.width() + side - 1) / side, rows = (frame.window.height() + side - 1) / side;
  const Sums sums = tbb::parallel_reduce(
      tbb::blocked_range<int>(0, rows), Sums{},
      [&](const auto& range, Sums sum) {
        for (int y = range.begin(); y < range.end(); ++y)
          for (int x = 0; x < columns; ++x) add_tile(tile_at(frame, x, y), lights, sum);
        return sum;
      },
      [](const Sums& a, const Sums& b) {
        return Sums{a.brute + b.brute, a.culled + b.culled,           a.in_range + b.in_range,
                    a.tiles + b.tiles, a.tile_lights + b.tile_lights, std::max(a.most, b.most)};
      });
  return {sums.brute, sums.culled, sums.in_range, sums.tiles > 0 ? sums.tile_lights / sums.tiles : 0, sums.most};
}

}  // namespace relume::bench
