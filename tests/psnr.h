// How far a picture is from a reference, for tests that choose the pixels.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "tests/channels.h"

namespace relume {

using Rgb = std::array<std::vector<float>, 3>;

inline Rgb rgb_of(const Channels& channels, const std::string& prefix = "") {
  return {channels.at(prefix + "R"), channels.at(prefix + "G"), channels.at(prefix + "B")};
}

/// dB over the pixels chosen; peak = the 99.9th percentile of the reference there. -1 where the reference is black.
inline double psnr(const Rgb& image, const Rgb& reference, const std::vector<bool>& chosen) {
  std::vector<float> values;
  double squares = 0;
  for (int k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      if (!chosen[i]) continue;
      values.push_back(reference[k][i]);
      const double error = double(image[k][i]) - reference[k][i];
      squares += error * error;
    }
  if (values.empty()) return -1;
  const auto rank = values.begin() + std::ptrdiff_t(double(values.size() - 1) * 0.999);
  std::nth_element(values.begin(), rank, values.end());
  const double peak = *rank;
  return peak > 0 ? -10 * std::log10(squares / double(values.size()) / (peak * peak)) : -1;
}

}  // namespace relume
