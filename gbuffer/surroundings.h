// The surfaces around a mixed pixel, as the pure pixels near it tell, and what each would be at the pixel.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "gbuffer/filtered_layers.h"

namespace relume {

struct Surface {
  Eigen::ArrayXd value, variance;  ///< of each component
  std::uint32_t id = 0;
};

struct Surroundings {
  std::vector<Surface> surfaces;  ///< the nearest first
  bool background = false;        ///< some pixel near shows no surface
  bool alpha_tells = true;        ///< it is 0 there
};

Surroundings surroundings(const FilteredLayers& layers, int x, int y);

}  // namespace relume
