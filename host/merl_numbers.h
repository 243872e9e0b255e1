// A measured BRDF as the kernel looks it up (kernels/specular/merl.h).
#pragma once

#include <vector>

#include "host/merl.h"

namespace relume {

/// Three counts, then the entries, rgb side by side, phi_d in 0..pi/2: f_r is the mean of phi_d's and of pi - phi_d's entry, which are mirror images
/// and, for a reciprocal BRDF, one thing. A channel that is not measured takes that of the next smaller theta_d that is, else of the next larger, so
/// that interpolation does not darken towards the horizon and across gaps; 0 where nothing is measured for its theta_h and phi_d.
std::vector<float> merl_numbers(const MerlTable& table);

/// Where a table may start in the table buffer: a kernel's parameter is a float, which holds such numbers up to 2^32.
constexpr std::size_t merl_alignment = 256;

}  // namespace relume
