// No lobe is negative, and none is infinite or not a number.
#include "lab/direction_pairs.h"
#include "lab/laws/list.h"

namespace relume {

Deviation law_positive(const Examined& lobe, const std::vector<std::string>&) {
  Deviation deviation;
  const std::vector<DirectionPair> pairs = direction_pairs();
  for (const Setting& setting : lobe.grid) {
    const std::vector<Reflectance> values = lobe.with(setting)(pairs);
    for (std::size_t i = 0; i < pairs.size(); ++i)
      for (int k = 0; k < 3; ++k) {
        const double value = values[i].total()[k];
        deviation.see(std::isfinite(value) ? -value : INFINITY, text_of(setting) + ", " + text_of(pairs[i]));
      }
  }
  return deviation;
}

}  // namespace relume
