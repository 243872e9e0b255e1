// merl_numbers: folded about phi_d = pi/2, then filled along theta_d.
#include "host/merl_numbers.h"

#include <tbb/parallel_for.h>

namespace relume {
namespace {

/// Of what is measured of an entry and its mirror image; negative where neither is.
float folded(float a, float b) {
  if (a < 0) return b;
  return b < 0 ? a : 0.5f * a + 0.5f * b;
}

/// Fills one column, along theta_d: forwards from what is measured, then backwards what lies before the first.
void fill(float* first, std::ptrdiff_t step, int count) {
  float last = -1;
  for (int d = 0; d < count; ++d) {
    float& value = first[d * step];
    if (value < 0) value = last;
    last = value;
  }
  for (int d = count - 1; d >= 0; --d) {
    float& value = first[d * step];
    if (value < 0) value = last < 0 ? 0 : last;
    last = value;
  }
}

}  // namespace

std::vector<float> merl_numbers(const MerlTable& table) {
  const int half = table.phi_d / 2;
  constexpr std::size_t header = 3;
  std::vector<float> numbers(header + 3 * table.entries() / 2);
  numbers[0] = float(table.theta_h);
  numbers[1] = float(table.theta_d);
  numbers[2] = float(half);
  const std::ptrdiff_t row = 3 * std::ptrdiff_t(half);
  tbb::parallel_for(0, table.theta_h, [&](int h) {
    float* layer = numbers.data() + header + std::ptrdiff_t(h) * table.theta_d * row;
    for (int d = 0; d < table.theta_d; ++d)
      for (int phi = 0; phi < half; ++phi)
        for (std::size_t c = 0; c < 3; ++c) {
          const std::vector<float>& f = table.f[c];
          layer[d * row + 3 * phi + int(c)] = folded(f[table.at(h, d, phi)], f[table.at(h, d, table.phi_d - 1 - phi)]);
        }
    for (std::ptrdiff_t column = 0; column < row; ++column) fill(layer + column, row, table.theta_d);
  });
  return numbers;
}

}  // namespace relume
