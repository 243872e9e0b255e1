// Integration over visible normals: Heitz and d'Eon 2014, "Importance Sampling Microfacet-Based BSDFs using the Distribution of Visible Normals";
// Beckmann's by Jakob 2014, "An Improved Visible Normal Sampling Routine for the Beckmann Distribution".
#include "host/rough_transmittance.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "host/gauss_legendre.h"

namespace relume {

namespace {

constexpr double pi = std::numbers::pi;

/// A slope of a surface with alpha = 1: `along` the viewing direction, `across` it; facets face (-along, -across, 1).
struct Slope {
  double along, across, weight;
};

/// The inverse of erf, to double precision: Winitzki's closed form, then Newton.
double inverse_erf(double y) {
  const double l = std::log1p(-y * y), a = 0.147, b = 2 / (pi * a) + 0.5 * l;
  double x = std::copysign(std::sqrt(std::sqrt(b * b - l / a) - b), y);
  for (int step = 0; step < 3; ++step) x -= (std::erf(x) - y) * 0.5 * std::sqrt(pi) * std::exp(x * x);
  return x;
}

/// Slopes of visible normals of GGX seen at cos_v (of the stretched direction): Shirley and Chiu's concentric map of the square to the disk.
/// The square's second half mirrors the first across the plane of incidence, so only the first is visited.
std::vector<Slope> ggx_slopes(const Quadrature& rule, double cos_v) {
  std::vector<Slope> slopes;
  const int order = int(rule.nodes.size());
  const double sin_v = std::sqrt(std::max(0.0, 1 - cos_v * cos_v));
  for (int i = 0; i < order / 2; ++i) {
    for (int j = 0; j < order; ++j) {
      const double u = 2 * rule.nodes[i] - 1, v = 2 * rule.nodes[j] - 1;
      const bool steep = std::abs(u) < std::abs(v);
      const double r = steep ? v : u, angle = 0.25 * pi * (steep ? 2 - u / v : v / u);
      const double x = r * std::cos(angle), edge = std::sqrt(std::max(0.0, 1 - x * x));
      const double y = edge + (r * std::sin(angle) - edge) * 0.5 * (1 + cos_v);
      const double z = std::sqrt(std::max(0.0, 1 - x * x - y * y)), norm = 1 / (sin_v * y + cos_v * z);
      slopes.push_back({(cos_v * y - sin_v * z) * norm, x * norm, 2 * rule.weights[i] * rule.weights[j]});
    }
  }
  return slopes;
}

/// The slope of Beckmann along the viewing direction at which the share `u` of what is seen at cos_v lies below it.
double beckmann_slope_along(double u, double cos_v) {
  const double tan_v = std::sqrt(std::max(0.0, 1 - cos_v * cos_v)) / cos_v, cot_v = 1 / std::max(tan_v, 1e-7);
  const double most = std::erf(cot_v), inverse_sqrt_pi = std::numbers::inv_sqrtpi;
  double x = most - (most + 1) * std::erf(std::sqrt(-std::log(u)));
  const double share = u * (1 + most + inverse_sqrt_pi * tan_v * std::exp(-cot_v * cot_v));
  for (int step = 0; step < 3; ++step) {  // as many as Mitsuba takes
    const double slope = inverse_erf(x);
    x -= (1 + x + inverse_sqrt_pi * tan_v * std::exp(-slope * slope) - share) / (1 - slope * tan_v);
  }
  return inverse_erf(x);
}

/// The same for Beckmann; slopes across are normally distributed.
std::vector<Slope> beckmann_slopes(const Quadrature& rule, double cos_v) {
  std::vector<Slope> slopes;
  const int order = int(rule.nodes.size());
  std::vector<double> across(order / 2);
  for (int j = 0; j < order / 2; ++j) across[j] = inverse_erf(2 * rule.nodes[j] - 1);
  for (int i = 0; i < order; ++i) {
    const double along = beckmann_slope_along(rule.nodes[i], cos_v);
    for (int j = 0; j < order / 2; ++j) slopes.push_back({along, across[j], 2 * rule.weights[i] * rule.weights[j]});
  }
  return slopes;
}

struct Refraction {
  double reflected;  ///< Fresnel's share, 1 where all is reflected
  double cos_t;      ///< cosine of the refracted ray to the facet's far side
};

Refraction fresnel(double cos_i, double eta) {
  const double cos2_t = 1 - (1 - cos_i * cos_i) / (eta * eta);
  if (cos2_t <= 0) return {1, 0};
  const double cos_t = std::sqrt(cos2_t);
  const double s = (cos_i - eta * cos_t) / (cos_i + eta * cos_t), p = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
  return {0.5 * (s * s + p * p), cos_t};
}

/// Smith's masking of one direction with this tan^2 to the normal; Beckmann's is Walter et al.'s rational fit (2007).
double smith_g1(bool beckmann, double alpha, double tan2) {
  const double a2tan2 = alpha * alpha * tan2;
  if (!beckmann) return 2 / (1 + std::sqrt(1 + a2tan2));
  const double a = 1 / std::sqrt(a2tan2);
  return a >= 1.6 ? 1 : (3.535 + 2.181 * a) * a / (1 + (2.276 + 2.577 * a) * a);
}

struct Shares {
  double reflected = 0, transmitted = 0;
};

/// Of light arriving at cosine mu from the side where the other is eta times as dense.
Shares shares_at(bool beckmann, double alpha, double eta, const Quadrature& rule, double mu) {
  const double sin_v = std::sqrt(1 - mu * mu), cos_v = mu / std::hypot(alpha * sin_v, mu);
  Shares shares;
  for (const Slope& s : beckmann ? beckmann_slopes(rule, cos_v) : ggx_slopes(rule, cos_v)) {
    const double mx = -alpha * s.along, my = -alpha * s.across, mz = 1 / std::sqrt(1 + mx * mx + my * my);
    const double v_m = (sin_v * mx + mu) * mz;
    const Refraction f = fresnel(v_m, eta);
    const double reflected_z = 2 * v_m * mz - mu, refracted_z = (v_m / eta - f.cos_t) * mz - mu / eta;
    const auto masking = [&](double z) { return smith_g1(beckmann, alpha, std::max(0.0, 1 - z * z) / (z * z)); };
    if (reflected_z > 0) shares.reflected += s.weight * f.reflected * masking(reflected_z);
    if (refracted_z < 0 && f.reflected < 1) shares.transmitted += s.weight * (1 - f.reflected) * masking(refracted_z);
  }
  return shares;
}

}  // namespace

RoughTransmittance rough_transmittance(bool beckmann, double alpha, double ior) {
  // The orders are Mitsuba's; from inside, total reflection makes the integrand rough.
  const Quadrature outside = gauss_legendre(ior > 1 ? 32 : 128), inside = gauss_legendre(ior > 1 ? 128 : 32);
  RoughTransmittance result;
  std::array<double, rough_transmittance_entries> internal;
  tbb::parallel_for(0, rough_transmittance_entries, [&](int i) {
    const double mu = std::max(1e-6, i / double(rough_transmittance_entries - 1));
    result.external[i] = float(shares_at(beckmann, alpha, ior, outside, mu).transmitted);
    internal[i] = 2 * mu / rough_transmittance_entries * shares_at(beckmann, alpha, 1 / ior, inside, mu).reflected;
  });
  result.internal_fdr = float(std::accumulate(internal.begin(), internal.end(), 0.0));  // in order: the same whoever computed what
  return result;
}

double smooth_internal_fdr(double ior) {
  const double x = 1 / ior;
  return (-1.4399 * x + 0.7099) * x + 0.6681 + 0.0636 * ior;
}

}  // namespace relume
