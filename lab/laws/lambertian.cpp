// A limit that many lobes have: without roughness, or without a surface above, they are Lambert's.
#include <numbers>

#include "lab/direction_pairs.h"
#include "lab/laws/list.h"

namespace relume {

Deviation law_lambertian(const Examined& lobe, const std::vector<std::string>& arguments) {
  Deviation deviation;
  const std::vector<DirectionPair> pairs = direction_pairs();
  for (const Setting& setting : lobe.grid) {
    const Setting limit = with_others(setting, arguments);
    const std::vector<Reflectance> values = lobe.with(limit)(pairs);
    for (std::size_t i = 0; i < pairs.size(); ++i)
      for (int k = 0; k < 3; ++k)
        deviation.see(std::abs(values[i].total()[k] * std::numbers::pi / pairs[i].l.z - 1), text_of(limit) + ", " + text_of(pairs[i]));
  }
  return deviation;
}

}  // namespace relume
