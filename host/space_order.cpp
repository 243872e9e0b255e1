// places_on_curve: the bits of three whole numbers in turns.
#include "host/space_order.h"

#include <algorithm>
#include <array>

namespace relume {
namespace {

/// The bits of a 10-bit number, two zeros between neighbours.
std::uint32_t spread(std::uint32_t v) {
  v = (v | v << 16) & 0x030000ff;
  v = (v | v << 8) & 0x0300f00f;
  v = (v | v << 4) & 0x030c30c3;
  return (v | v << 2) & 0x09249249;
}

}  // namespace

std::vector<std::uint32_t> places_on_curve(std::span<const float> x, std::span<const float> y, std::span<const float> z) {
  std::vector<std::uint32_t> places(x.size());
  if (x.empty()) return places;
  const std::array axes{x, y, z};
  for (std::size_t c = 0; c < 3; ++c) {
    const auto [low, high] = std::minmax_element(axes[c].begin(), axes[c].end());
    const float start = *low, side = *high - start;
    if (!(side > 0)) continue;
    for (std::size_t i = 0; i < places.size(); ++i) places[i] |= spread(std::uint32_t(1023 * ((axes[c][i] - start) / side))) << c;
  }
  return places;
}

}  // namespace relume
