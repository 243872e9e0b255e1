// ior_from_specular_level.
#include "host/ior.h"

#include <cmath>

namespace relume {

double ior_from_specular_level(double level) { return 2 / (1 - std::sqrt(0.08 * level)) - 1; }

}  // namespace relume
