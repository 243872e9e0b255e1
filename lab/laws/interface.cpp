// White paint under a clear surface: all light that enters leaves again, so that what the base reflects and what the surface mirrors are all there
// is.
#include <numbers>

#include "lab/direction_pairs.h"
#include "lab/furnace.h"
#include "lab/laws/list.h"

namespace relume {

/// Of smooth surfaces; a rough one's Fresnel reflectance is no term.
Deviation law_interface(const Examined& lobe, const std::vector<std::string>&) {
  Deviation deviation;
  std::vector<Setting> settings;
  for (const Setting& setting : lobe.grid)
    if (value_in(setting, "alpha").empty() && value_in(setting, "roughness").empty()) settings.push_back(setting);
  std::vector<DirectionPair> pairs;
  for (const double angle : furnace_angles) pairs.push_back(mirrored(std::cos(angle * std::numbers::pi / 180)));
  for (const FurnaceRow& row : furnace(lobe, settings)) {
    const std::string ior = value_in(row.setting, "ior");
    const std::vector<TermValues> terms = lobe.terms("ggx", {"fresnel=dielectric", ior.empty() ? "ior=1.5" : "ior=" + ior})(pairs);
    for (std::size_t i = 0; i < pairs.size(); ++i) deviation.see(std::abs(row.albedo[i] + terms[i].f.x - 1), place_of(row, i));
  }
  return deviation;
}

}  // namespace relume
