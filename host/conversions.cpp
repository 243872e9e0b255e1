// The formulas (research: exr-conventions E.2): glTF and MaterialX for alpha = roughness^2, Walter et al. 2007 for exponents, Fresnel for f0.
#include "host/conversions.h"

#include <algorithm>
#include <cmath>

namespace relume {
namespace {

double squared(double x) { return x * x; }
double alpha_of_exponent(double e) { return std::sqrt(2 / (std::max(e, 0.0) + 2)); }

}  // namespace

const std::vector<Conversion>& conversions() {
  static const std::vector<Conversion> list{
      {"alpha", "roughness", [](double r) { return r * r; }, "roughness^2"},
      {"alpha", "glossiness", [](double g) { return squared(1 - g); }, "(1 - glossiness)^2"},
      {"alpha", "exponent", alpha_of_exponent, "sqrt(2/(exponent + 2))"},
      {"roughness", "glossiness", [](double g) { return 1 - g; }, "1 - glossiness"},
      {"roughness", "alpha", [](double a) { return std::sqrt(std::max(a, 0.0)); }, "sqrt(alpha)"},
      {"roughness", "exponent", [](double e) { return std::sqrt(alpha_of_exponent(e)); }, "(2/(exponent + 2))^(1/4)"},
      {"f0", "ior", [](double n) { return squared((n - 1) / (n + 1)); }, "((ior - 1)/(ior + 1))^2"},
      {"f0", "specular_level", [](double l) { return 0.08 * l; }, "0.08 specular_level"},
  };
  return list;
}

double ior_from_specular_level(double level) { return 2 / (1 - std::sqrt(0.08 * level)) - 1; }

}  // namespace relume
