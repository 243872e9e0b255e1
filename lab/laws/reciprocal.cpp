// f_r stays the same when light and viewer change places: Helmholtz's reciprocity.
#include <algorithm>

#include "lab/direction_pairs.h"
#include "lab/laws/list.h"

namespace relume {

Deviation law_reciprocal(const Examined& lobe, const std::vector<std::string>&) {
  Deviation deviation;
  const std::vector<DirectionPair> pairs = direction_pairs();
  std::vector<DirectionPair> swapped;
  for (const DirectionPair& pair : pairs) swapped.push_back({pair.v, pair.l});
  for (const Setting& setting : lobe.grid) {
    const ReflectanceOf reflectance = lobe.with(setting);
    const std::vector<Reflectance> there = reflectance(pairs), back = reflectance(swapped);
    for (std::size_t i = 0; i < pairs.size(); ++i)
      for (int k = 0; k < 3; ++k) {
        const double a = there[i].total()[k] / pairs[i].l.z, b = back[i].total()[k] / pairs[i].v.z;
        // Below 1e-30 what is left of a float's digits is few.
        deviation.see(std::abs(a - b) / (std::max(a, b) + 1e-30), text_of(setting) + ", " + text_of(pairs[i]));
      }
  }
  return deviation;
}

}  // namespace relume
