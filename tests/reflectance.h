// Directions and directional albedos of the kernels' lobes, for tests of laws and of tables.
#pragma once

#include <algorithm>
#include <cmath>

#include "tests/kernel_lanes.h"

namespace relume {

struct Direction {
  double x, y, z;
};
inline double dot(const Direction& a, const Direction& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// f_r n.l of the lobe, its first channel; n is +z.
inline double reflectance(const kernel::Lobe& lobe, kernel::Surface s, const Direction& l, const Direction& v) {
  s.n_v = static_cast<float>(v.z);
  return kernel::reflect_lobe(lobe, kernel::cosines_from(l.z, v.z, dot(l, v)), s).x;
}

/// Integral of f_r n.l over the hemisphere of l, by midpoints: `steps` in the polar angle, denser towards both ends, and half as many in half of the
/// azimuth. Width 0: directions with pdf cos/pi. Else half vectors with the pdf of GGX of that width, which is as heavy-tailed as any lobe here.
inline double directional_albedo(const kernel::Lobe& lobe, const kernel::Surface& s, double n_v, double width, int steps) {
  constexpr double pi = 3.14159265358979323846;
  const Direction v{std::sqrt(1 - n_v * n_v), 0, n_v};
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double x = (i + 0.5) / steps;
    const double u = x * x * x * (10 - 15 * x + 6 * x * x);
    const double weight = 30 * x * x * (1 - x) * (1 - x) / (steps * (steps / 2));
    const double tan2 = width == 0 ? (1 - u) / u : width * width * u / (1 - u);
    const double cosine = 1 / std::sqrt(1 + tan2);
    const double sine = std::sqrt(tan2) * cosine;
    const double pdf = width == 0 ? cosine / pi : width * width / (pi * std::pow(cosine, 3) * std::pow(width * width + tan2, 2));
    for (int j = 0; j < steps / 2; ++j) {
      const double phi = pi * (j + 0.5) / (steps / 2);
      const Direction at{sine * std::cos(phi), sine * std::sin(phi), cosine};
      const double v_h = dot(v, at);
      const Direction mirrored{2 * v_h * at.x - v.x, 2 * v_h * at.y - v.y, 2 * v_h * at.z - v.z};
      if (width == 0)
        sum += weight * reflectance(lobe, s, at, v) / pdf;
      else if (v_h > 0 && mirrored.z > 0)
        sum += weight * reflectance(lobe, s, mirrored, v) * 4 * v_h / pdf;
    }
  }
  return sum;
}

/// The width of the half vectors' distribution that suits a lobe with this surface; 0 where the whole hemisphere does.
inline double half_vector_width(const kernel::Lobe& lobe, const kernel::Surface& s) {
  if (lobe.kind == "diffuse") return 0;
  if (lobe.parameters.find("exponent") != std::string_view::npos) {
    const bool about_mirror = lobe.name.substr(0, 5) == "phong";  // R_v turns twice as fast as h
    return s.exponent <= 20 ? 0 : std::sqrt(2 / (s.exponent * (about_mirror ? 4 : 1) + 2.0));
  }
  return std::max(lobe.parameters.find("alpha") == std::string_view::npos ? s.roughness * s.roughness : s.alpha, 1e-4f);
}

}  // namespace relume
