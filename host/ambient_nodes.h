// The quadrature of kernels/ambient.h: nodes over the hemisphere, one half of it, since every lobe is mirror-symmetric.
#pragma once

#include <vector>

namespace relume {

/// Four floats a node: tan^2 theta = u/(1-u) at Gauss-Legendre nodes u of (0, 1), cos phi, sin phi at midpoints of (0, pi), weight (they sum to 1).
std::vector<float> ambient_nodes();

}  // namespace relume
