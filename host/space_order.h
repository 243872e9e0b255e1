// Points in an order that keeps neighbours together: Morton 1966, "A Computer Oriented Geodetic Data Base and a New Technique in File Sequencing".
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace relume {

/// Each point's place along Morton's curve through the box of all, 2^10 steps to a side: below 2^30.
std::vector<std::uint32_t> places_on_curve(std::span<const float> x, std::span<const float> y, std::span<const float> z);

}  // namespace relume
