// The lecture's unnormalised lobes: the greatest f_r n.l is the coefficient itself, in the mirror direction or straight on.
#include <algorithm>

#include "lab/direction_pairs.h"
#include "lab/laws/list.h"

namespace relume {

Deviation law_peak(const Examined& lobe, const std::vector<std::string>&) {
  Deviation deviation;
  std::vector<DirectionPair> pairs = direction_pairs();
  for (const double cosine : {1.0, 0.9, 0.5, 0.1}) pairs.push_back(mirrored(cosine));
  for (const Setting& setting : lobe.grid) {
    double greatest = 0;
    for (const Reflectance& value : lobe.with(setting)(pairs)) greatest = std::max(greatest, value.total().x);
    deviation.see(std::abs(greatest - 1), text_of(setting));
  }
  return deviation;
}

}  // namespace relume
