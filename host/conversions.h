// Parameters made from others that say the same in other words: roughness from glossiness, alpha from roughness, f0 from an index of refraction.
#pragma once

#include <string_view>
#include <vector>

namespace relume {

using Convert = double (*)(double);

struct Conversion {
  std::string_view to, from;  ///< a parameter; a parameter or a role ("glossiness")
  Convert convert;
  std::string_view formula;  ///< for people
};

/// In order of preference.
const std::vector<Conversion>& conversions();

/// Mitsuba's and Disney's principled: f0 = 0.08 level, ior = 2/(1 - sqrt(f0)) - 1.
double ior_from_specular_level(double level);

}  // namespace relume
