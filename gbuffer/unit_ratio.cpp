// unit_ratio_near.
#include "gbuffer/unit_ratio.h"

#include <cmath>

namespace relume {

std::optional<double> unit_ratio_near(double scale, double tolerance) {
  std::optional<double> best;
  for (const double a : {1.0, 0.01, 0.1, 0.001, 0.0254, 0.3048, 0.9144, 1000.0})  // metre, centimetre, ..., inch, foot, yard, kilometre
    for (const double b : {1.0, 0.01, 0.1, 0.001, 0.0254, 0.3048, 0.9144, 1000.0})
      if (const double distance = std::abs(scale * b / a - 1); distance < 0.999 * tolerance) best = a / b, tolerance = distance;
  return best;
}

}  // namespace relume
