// Means over the facets of a GGX surface that a viewer sees: Heitz 2018, "Sampling the GGX Distribution of Visible Normals".
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/gauss_legendre.h"

namespace relume {

/// The mean of value(cosine between view and facet, cosine between normal and reflected ray) over the facets seen at n.v = mu; facets that
/// reflect below the horizon count 0. 0 < mu <= 1, alpha > 0.
///
/// Stretched by 1/alpha the facets' normals are those of a hemisphere, each seen with its projected area. It is cut into slices across the plane of
/// incidence; in a slice, the normals that reflect above the horizon lie between two angles known in closed form, so the integrand has no step.
template <typename Value>
double mean_over_visible_normals(double alpha, double mu, const Quadrature& slices, const Quadrature& along, const Value& value) {
  const double sine = std::sqrt(1 - mu * mu), stretched = std::hypot(alpha * sine, mu), a2 = alpha * alpha, mu2 = mu * mu;
  const double view_angle = std::atan2(alpha * sine, mu);  // of the stretched view, from the normal
  // A facet with slope x along the view, in the slice of latitude beta, reflects above the horizon where
  // mu (1 + tan^2 beta) x^2 - 2 sine x - mu (1 - a2 tan^2 beta) <= 0; the last slice is where the discriminant vanishes.
  const double last_tan2 = (mu2 * (1 - a2) + std::sqrt(mu2 * mu2 * (1 - a2) * (1 - a2) + 4 * a2 * mu2)) / (2 * a2 * mu2);
  const double last = std::atan(std::sqrt(last_tan2));
  double sum = 0;
  for (std::size_t i = 0; i < slices.nodes.size(); ++i) {
    const double t = slices.nodes[i], beta = last * t * (2 - t);  // denser at the last slice, where the tangents meet like a square root
    const double tan2 = std::tan(beta) * std::tan(beta), radius = std::cos(beta), bend = mu * (1 + tan2);
    const double root = std::sqrt(std::max(0.0, sine * sine + mu * bend * (1 - a2 * tan2)));
    const double low = std::max(std::atan((sine - root) / (bend * alpha)), view_angle - 0.5 * std::numbers::pi);
    const double width = std::atan((sine + root) / (bend * alpha)) - low;
    double slice = 0;
    for (std::size_t j = 0; j < along.nodes.size(); ++j) {
      const double u = along.nodes[j], delta = low + width * u * u * (3 - 2 * u);  // denser at the horizon, where shadowing changes fast
      const double x = alpha * std::tan(delta), y2 = tan2 * (a2 + x * x), m2 = 1 / (1 + x * x + y2);  // (n.m)^2
      const double facing = sine * x + mu;
      slice += along.weights[j] * 6 * u * (1 - u) * std::cos(delta - view_angle) * value(facing * std::sqrt(m2), 2 * facing * m2 - mu);
    }
    sum += slices.weights[i] * last * 2 * (1 - t) * radius * radius * width * slice;
  }
  // All that is seen of the stretched hemisphere has the projected area pi/2 (1 + mu/stretched), half of it on each side of the plane of incidence.
  return 4 / std::numbers::pi * sum * stretched / (stretched + mu);
}

}  // namespace relume
