// Order statistics of measurements.
#include "bench/subject.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace relume::bench {

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const double at = share * double(values.size() - 1);
  const std::size_t below = std::size_t(at), above = std::min(below + 1, values.size() - 1);
  return values[below] + (values[above] - values[below]) * (at - double(below));
}

double Measurement::least() const { return quantile(seconds, 0); }
double Measurement::median() const { return quantile(seconds, 0.5); }

}  // namespace relume::bench
