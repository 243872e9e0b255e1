// The quadrature of kernels/ambient.h: nodes over the hemisphere, one half of it, since every lobe is mirror-symmetric.
#pragma once

#include <vector>

namespace relume {

/// Four floats a node: u = x (2 - x) at Gauss-Legendre nodes x of (0, 1), denser at the horizon, u = 1, where shadowing changes fast; cos phi, sin
/// phi at midpoints of (0, pi); weight (they sum to 1).
/// 16 x 12 on the half: tests/ambient_test.cpp prints what error that leaves, lobe by lobe.
std::vector<float> ambient_nodes(int u_nodes = 16, int phi_nodes = 12);

}  // namespace relume
