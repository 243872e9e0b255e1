// ambient_nodes: a product rule of Gauss-Legendre and midpoints.
#include "host/ambient_nodes.h"

#include <cmath>
#include <numbers>

#include "host/gauss_legendre.h"

namespace relume {

std::vector<float> ambient_nodes(int u_nodes, int phi_nodes) {
  const Quadrature rule = gauss_legendre(u_nodes);
  std::vector<float> nodes;
  for (int i = 0; i < u_nodes; ++i)
    for (int j = 0; j < phi_nodes; ++j) {
      const double x = rule.nodes[i], u = x * (2 - x), phi = std::numbers::pi * (j + 0.5) / phi_nodes;
      for (const double value : {u, std::cos(phi), std::sin(phi), rule.weights[i] * 2 * (1 - x) / phi_nodes}) nodes.push_back(float(value));
    }
  return nodes;
}

}  // namespace relume
