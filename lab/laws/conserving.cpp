// No more light leaves than arrives: the directional albedo is at most 1 from every direction.
#include "lab/furnace.h"
#include "lab/laws/list.h"

namespace relume {

Deviation law_conserving(const Examined& lobe, const std::vector<std::string>&) {
  Deviation deviation;
  for (const FurnaceRow& row : lobe.furnace)
    for (std::size_t i = 0; i < row.albedo.size(); ++i) deviation.see(row.albedo[i] - 1, place_of(row, i));
  return deviation;
}

}  // namespace relume
