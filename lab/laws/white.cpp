// The white furnace test: what reflects all light, in one bounce or many, cannot be told from the furnace around it, from any direction.
#include "lab/furnace.h"
#include "lab/laws/list.h"

namespace relume {

Deviation law_white(const Examined& lobe, const std::vector<std::string>&) {
  Deviation deviation;
  for (const FurnaceRow& row : lobe.furnace)
    for (std::size_t i = 0; i < row.albedo.size(); ++i) deviation.see(std::abs(row.albedo[i] - 1), place_of(row, i));
  return deviation;
}

}  // namespace relume
