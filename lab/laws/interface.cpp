// White paint under a clear surface: all light that enters leaves again, so that what the base reflects and what the surface mirrors are all there
// is.
#include <numbers>

#include "lab/direction_pairs.h"
#include "lab/furnace.h"
#include "lab/laws/list.h"

namespace relume {
namespace {

double ior_in(const Setting& setting) {
  const std::string ior = value_in(setting, "ior");
  return ior.empty() ? find_parameter("ior")->fallback : std::stod(ior);
}

}  // namespace

/// Of smooth surfaces (a rough one's Fresnel reflectance is no term) of an ior up to 2, for which the fit of the inner reflectance was made.
Deviation law_interface(const Examined& lobe, const std::vector<std::string>&) {
  Deviation deviation;
  std::vector<Setting> settings;
  for (const Setting& setting : lobe.grid)
    if (value_in(setting, "alpha").empty() && value_in(setting, "roughness").empty() && ior_in(setting) <= 2) settings.push_back(setting);
  std::vector<DirectionPair> pairs;
  for (const double angle : furnace_angles) pairs.push_back(mirrored(std::cos(angle * std::numbers::pi / 180)));
  for (const FurnaceRow& row : furnace(lobe, settings)) {
    const std::vector<TermValues> terms = lobe.terms("ggx", {"fresnel=dielectric", "ior=" + std::to_string(ior_in(row.setting))})(pairs);
    for (std::size_t i = 0; i < pairs.size(); ++i) deviation.see(std::abs(row.albedo[i] + terms[i].f.x - 1), place_of(row, i));
  }
  return deviation;
}

}  // namespace relume
