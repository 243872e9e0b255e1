// The albedos that Cycles writes to its GlossCol pass for the metal and the dielectric of a Principled BSDF.
#pragma once

#include <array>

namespace relume {

/// One roughness and viewing angle.
class CyclesAlbedo {
 public:
  /// `multi_ggx`: with the energy of later bounces. The tables behind it are made once, in about 30 ms.
  CyclesAlbedo(double roughness, double n_v, bool multi_ggx);

  /// For a base colour 0..1 (one channel).
  double metal(double base) const;
  /// For a reflectance at normal incidence, 0..0.96. Grows with it.
  double dielectric(double f0) const;

 private:
  double energy(double mean_fresnel) const;

  bool multi_ggx_;
  double albedo_, mean_albedo_;             // of one bounce without Fresnel
  double metal_ramp_;                       // share of the way from f0 to 1 that Fresnel has gone, averaged over what is seen
  std::array<double, 16> dielectric_ramp_;  // the same for f0 = (i/15)^4
};

}  // namespace relume
