// Straight on, with light and viewer along the normal, a diffuse lobe that bends with the angle is Lambert's: its factors are all 1 there.
#include <numbers>

#include "lab/direction_pairs.h"
#include "lab/laws/list.h"

namespace relume {

Deviation law_normal(const Examined& lobe, const std::vector<std::string>& arguments) {
  Deviation deviation;
  const std::vector<DirectionPair> straight{facing(1)};
  for (const Setting& setting : lobe.grid) {
    const Setting tried = with_others(setting, arguments);
    const glm::dvec3 value = lobe.with(tried)(straight).front().total();
    for (int k = 0; k < 3; ++k) deviation.see(std::abs(value[k] * std::numbers::pi - 1), text_of(tried));
  }
  return deviation;
}

}  // namespace relume
