// The middle one of many numbers.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

namespace relume {

/// The upper one of an even number; infinite where there are none.
inline double median(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::infinity();
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace relume
