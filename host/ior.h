// One parameter for another: the index of refraction that a specular level stands for.
#pragma once

namespace relume {

/// Mitsuba's and Disney's principled: f0 = 0.08 level, ior = 2/(1 - sqrt(f0)) - 1.
double ior_from_specular_level(double level);

}  // namespace relume
