// The quadrature of kernels/ambient.h: nodes over the hemisphere, one half of it, since every lobe is mirror-symmetric.
#pragma once

#include <vector>

namespace relume {

/// Four floats a node: u = x (2 - x) at Gauss-Legendre nodes x of (0, 1), denser at the horizon, u = 1, where shadowing changes fast; cos phi, sin
/// phi at midpoints of (0, pi); weight (they sum to 1).
std::vector<float> ambient_nodes();

}  // namespace relume
