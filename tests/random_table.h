// A measured table of random numbers, for tests.
#pragma once

#include <random>

#include "host/merl.h"

namespace relume {

/// Every entry is its own number in 0.1..1, `measured` of them; the others -1.
inline MerlTable random_table(int theta_h, int theta_d, int phi_d, double measured = 1) {
  MerlTable table{theta_h, theta_d, phi_d, {}};
  std::mt19937 random(7);
  std::uniform_real_distribution<float> value(0.1f, 1), chance(0, 1);
  for (auto& plane : table.f)
    for (std::size_t i = 0; i < table.entries(); ++i) plane.push_back(chance(random) < measured ? value(random) : -1);
  return table;
}

}  // namespace relume
