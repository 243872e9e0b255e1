// What a rough dielectric surface lets through: the transmittance table and internal reflectance of a plastic's diffuse base, as Mitsuba's
// roughplastic has them.
#pragma once

#include <array>

namespace relume {

/// Entries of the table; entry i is for the cosine i/(entries - 1).
inline constexpr int rough_transmittance_entries = 64;

struct RoughTransmittance {
  std::array<float, rough_transmittance_entries> external;  ///< share of the light from a direction that enters the surface
  float internal_fdr;                                       ///< share of diffuse light that the surface throws back inside
};

/// For a Beckmann or GGX surface of this alpha (slope width) and index of refraction, interior over exterior; about 10 ms.
/// The quadrature is Mitsuba's: its error at grazing angles is part of the pictures to match.
RoughTransmittance rough_transmittance(bool beckmann, double alpha, double ior);

/// The internal reflectance of a smooth surface: the fit of Egan and Hilgeman 1973, "Diffuse Reflection", within 0.6 % up to ior 2.
double smooth_internal_fdr(double ior);

}  // namespace relume
