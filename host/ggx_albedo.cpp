// ggx_albedo: visible normals under a product rule; cycles_tables: on the grid that Cycles reads.
#include "host/ggx_albedo.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "host/visible_normals.h"
#include "kernels/cycles_tables.h"

namespace relume {

namespace {

/// Heitz 2014, "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs", equation 72.
double ggx_lambda(double alpha, double cosine) { return 0.5 * (std::sqrt(1 + alpha * alpha * (1 / (cosine * cosine) - 1)) - 1); }

/// The mean over a hemisphere of incident light, 2 integral of mu E(mu).
double mean_albedo(double alpha, const Quadrature& rule) {
  double sum = 0;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) sum += rule.weights[i] * 2 * rule.nodes[i] * ggx_albedo(alpha, rule.nodes[i]);
  return sum;
}

}  // namespace

double ggx_albedo(double alpha, double mu) {
  static const Quadrature slices = gauss_legendre(16), along = gauss_legendre(24);  // 1e-5 for every roughness from 1/31, measured
  const double seen = 1 + ggx_lambda(alpha, mu);
  return mean_over_visible_normals(alpha, mu, slices, along,
                                   [&](double, double n_l) { return n_l > 0 ? seen / (seen + ggx_lambda(alpha, n_l)) : 0; });
}

std::vector<float> cycles_tables() {
  constexpr int side = RELUME_CYCLES_TABLE_SIDE;
  constexpr double least_cosine = 1e-4;  // Cycles' first entry stands for this
  const Quadrature rule = gauss_legendre(24);
  std::vector<float> tables(RELUME_CYCLES_TABLES_LENGTH, 1.0f);  // a mirror, roughness 0, reflects all
  tbb::parallel_for(1, side, [&](int r) {
    const double roughness = r / double(side - 1), alpha = roughness * roughness;
    for (int m = 0; m < side; ++m) {
      tables[RELUME_CYCLES_E_START + m * side + r] = float(ggx_albedo(alpha, std::max(least_cosine, m / double(side - 1))));
    }
    tables[RELUME_CYCLES_E_MEAN_START + r] = float(mean_albedo(alpha, rule));
  });
  return tables;
}

}  // namespace relume
