// gauss_legendre: Newton's method on Legendre polynomials (Press et al., Numerical Recipes, 4.6).
#include "host/gauss_legendre.h"

#include <cmath>
#include <numbers>

namespace relume {

namespace {

struct Legendre {
  double value, derivative;
};

/// The Legendre polynomial of this order at x, by its three-term recurrence.
Legendre legendre(int order, double x) {
  double previous = 1, value = x;
  for (int k = 2; k <= order; ++k) {
    const double next = ((2 * k - 1) * x * value - (k - 1) * previous) / k;
    previous = value;
    value = next;
  }
  return {value, order * (x * value - previous) / (x * x - 1)};
}

}  // namespace

Quadrature gauss_legendre(int order) {
  Quadrature rule{std::vector<double>(order), std::vector<double>(order)};
  for (int i = 0; i < order; ++i) {
    double x = -std::cos(std::numbers::pi * (i + 0.75) / (order + 0.5));  // within 1e-3 of the root: Newton doubles the digits each time
    Legendre p = legendre(order, x);
    for (int step = 0; step < 6; ++step) {
      x -= p.value / p.derivative;
      p = legendre(order, x);
    }
    rule.nodes[i] = 0.5 * (1 + x);
    rule.weights[i] = 1 / ((1 - x * x) * p.derivative * p.derivative);
  }
  return rule;
}

}  // namespace relume
