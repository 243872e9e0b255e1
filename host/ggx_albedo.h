// The directional albedo of GGX with height-correlated Smith shadowing and no Fresnel: what Cycles compensates for.
#pragma once

#include <vector>

namespace relume {

/// The share of light from the cosine mu that a GGX surface of this alpha reflects in one bounce; to 1e-5. 0 < mu <= 1, alpha > 0.
double ggx_albedo(double alpha, double mu);

/// The tables of kernels/cycles_tables.h, which stand at the start of the table buffer; about 20 ms.
std::vector<float> cycles_tables();

}  // namespace relume
