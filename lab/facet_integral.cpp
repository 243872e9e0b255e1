// projected_area: Gauss-Legendre on panels of the polar angle that grow by a quarter from a tenth of the narrowest lobe's width; all is symmetric
// about n.
#include "lab/facet_integral.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/gauss_legendre.h"

namespace relume {

double projected_area(const FacetValues& values) {
  const Quadrature rule = gauss_legendre(16);
  std::vector<DirectionPair> pairs;
  std::vector<double> weights;
  for (double from = 0, to = 1e-5; from < std::numbers::pi / 2; from = to, to = std::min(1.25 * to, std::numbers::pi / 2))
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      const double angle = from + (to - from) * rule.nodes[i];
      const glm::dvec3 h{std::sin(angle), 0, std::cos(angle)};
      pairs.push_back({h, h});
      weights.push_back(2 * std::numbers::pi * h.x * h.z * (to - from) * rule.weights[i]);
    }
  const std::vector<double> at = values(pairs);
  double sum = 0;
  for (std::size_t i = 0; i < at.size(); ++i) sum += weights[i] * at[i];
  return sum;
}

}  // namespace relume
