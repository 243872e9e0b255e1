// place_sampled: texels, cumulative shares of their light, and low-discrepancy points.
#include "host/device_environment.h"

#include <cmath>
#include <cstdint>
#include <numbers>

namespace relume {
namespace {

/// kernels/environment/map.h's.
double luminance(const std::array<float, 3>& c) { return 0.2125 * c[0] + 0.7154 * c[1] + 0.0721 * c[2]; }

int append(std::vector<float>& tables, const std::vector<float>& values) {
  const int first = int(tables.size());
  tables.insert(tables.end(), values.begin(), values.end());
  return first;
}

/// Running sums over their last, which is 1 after rounding too; nothing but that where all are 0.
void append_shares(std::vector<float>& shares, const std::vector<double>& values) {
  double sum = 0, all = 0;
  for (const double value : values) all += value;
  for (const double value : values) shares.push_back(float(all > 0 ? (sum += value) / all : 1));
  shares.back() = 1;
}

/// A Fibonacci lattice's second coordinates: steps of the golden ratio, the number that fractions come nearest to least.
std::vector<float> points_of(int samples) {
  std::vector<float> points;
  for (int k = 0; k < samples; ++k) points.push_back(float(std::fmod(k / std::numbers::phi, 1.0)));
  return points;
}

struct Shares {
  std::vector<float> columns;
  std::vector<double> rows;  ///< light of each, lm or W for each m^2
};

Shares shares_of(const EnvironmentMap& map, const std::vector<double>& solid_angles) {
  Shares shares;
  shares.columns.reserve(map.radiance.size());
  std::vector<double> row(std::size_t(map.width));
  for (int i = 0; i < map.height; ++i) {
    double sum = 0;
    for (int j = 0; j < map.width; ++j)
      sum += row[std::size_t(j)] = luminance(map.radiance[std::size_t(i) * std::size_t(map.width) + std::size_t(j)]) * solid_angles[std::size_t(i)];
    append_shares(shares.columns, row);
    shares.rows.push_back(sum);
  }
  return shares;
}

/// Shares of a texel over the area of its tent, which a pole halves where rows end on it, in texels; then texels over steradians at the equator.
std::vector<float> row_densities(const EnvironmentMap& map, const std::vector<double>& solid_angles, double all) {
  std::vector<float> densities;
  const double per_steradian = double(map.width) * map.row_steps() / (2 * std::numbers::pi * std::numbers::pi);
  for (int i = 0; i < map.height; ++i) {
    const bool halved = map.rows_on_border && (i == 0 || i == map.height - 1);
    densities.push_back(float(solid_angles[std::size_t(i)] / all / (halved ? 0.5 : 1) * per_steradian));
  }
  return densities;
}

/// Wellons 2018, "Hash Prospector": lowbias32.
std::uint32_t hash(std::uint32_t x) {
  x = (x ^ (x >> 16)) * 0x7feb352dU;
  x = (x ^ (x >> 15)) * 0x846ca68bU;
  return x ^ (x >> 16);
}

}  // namespace

EnvironmentImage place_image(const EnvironmentMap& map, std::vector<float>& tables) {
  const int first = int(tables.size());
  tables.reserve(tables.size() + 3 * map.radiance.size());
  for (const std::array<float, 3>& texel : map.radiance) tables.insert(tables.end(), texel.begin(), texel.end());
  return {map.width, map.height, float(map.column_shift()), float(map.row_shift()), float(map.row_steps()), first};
}

EnvironmentRecord place_environment(const DeviceEnvironment& environment, std::vector<float>& tables) {
  EnvironmentRecord record{};
  record.image = place_image(environment.map, tables);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) record.world_from_map[3 * row + column] = float(environment.world_from_map[column][row]);
  return record;
}

EnvironmentRecord place_sampled(const DeviceEnvironment& environment, int samples, std::vector<float>& tables) {
  const EnvironmentMap& map = environment.map;
  EnvironmentRecord record = place_environment(environment, tables);
  const std::vector<double> solid_angles = map.solid_angles();
  const Shares shares = shares_of(map, solid_angles);
  double all = 0;
  for (const double row : shares.rows) all += row;
  record.row_density = append(tables, row_densities(map, solid_angles, all));
  record.column_shares = append(tables, shares.columns);
  record.row_shares = int(tables.size());
  append_shares(tables, shares.rows);
  record.points = append(tables, points_of(samples));
  record.samples = samples;
  return record;
}

float scrambled(int x, int y, int surface, unsigned salt) {
  const std::uint32_t mixed = hash(hash(hash(std::uint32_t(x) + salt * 0x9e3779b9U) ^ std::uint32_t(y)) + std::uint32_t(surface));
  return float(mixed >> 8) / float(1 << 24);
}

}  // namespace relume
