// The constant before a lobe is the greatest that conserves energy: from some direction all light is reflected. For Phong's forms straight on.
#include <algorithm>

#include "lab/furnace.h"
#include "lab/laws/list.h"

namespace relume {

Deviation law_normalised(const Examined& lobe, const std::vector<std::string>&) {
  Deviation deviation;
  for (const FurnaceRow& row : lobe.furnace) {
    const auto greatest = std::max_element(row.albedo.begin(), row.albedo.end());
    deviation.see(std::abs(*greatest - 1), place_of(row, std::size_t(greatest - row.albedo.begin())));
  }
  return deviation;
}

}  // namespace relume
