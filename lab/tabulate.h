// A BRDF of the kernels as a MERL table: what Rusinkiewicz's angles mean, and a lobe asked for all of them.
#pragma once

#include "host/merl.h"
#include "lab/brdf.h"

namespace relume {

/// The directions of half and difference angles: h in the xz-plane, and l turned out of it by theta_d, phi_d about it (Rusinkiewicz 1998, "A New
/// Change of Variables for Efficient BRDF Representation"). Either may lie below the horizon.
DirectionPair directions_of(const MerlAngles& angles);

/// f_r at the middle of every bin; below 0 where l or v is below the horizon, as in measured files. A table cannot hold a BRDF that is not
/// reciprocal: what it has for l and v is then what lookups give for both orders, by halves (host/merl_numbers.h).
MerlTable tabulate(const Brdf& brdf, int theta_h = 90, int theta_d = 90, int phi_d = 180);

}  // namespace relume
