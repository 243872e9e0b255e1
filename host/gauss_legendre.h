// Gauss-Legendre quadrature on 0..1.
#pragma once

#include <vector>

namespace relume {

struct Quadrature {
  std::vector<double> nodes;    ///< ascending, in 0..1
  std::vector<double> weights;  ///< their sum is 1
};

Quadrature gauss_legendre(int order);

}  // namespace relume
