// What one bounce loses is given back by a table of albedo: as white as the table's 32 x 32 places let it be.
#include "lab/furnace.h"
#include "lab/laws/list.h"

namespace relume {

/// Of the multiple-scattering distribution, with the arguments set; where the table is fine enough, which it is not for smooth surfaces (up to 9 %
/// off at grazing angles).
Deviation law_compensated(const Examined& lobe, const std::vector<std::string>& arguments) {
  constexpr double steepest = 80;
  Deviation deviation;
  std::vector<Setting> settings;
  for (const char* roughness : {"0.3", "0.4", "0.5", "0.6", "0.8", "1"})
    settings.push_back(with_others(with_others(lobe.grid.front(), {"distribution=multi_ggx", std::string("roughness=") + roughness}), arguments));
  for (const FurnaceRow& row : furnace(lobe, settings))
    for (std::size_t i = 0; i < row.albedo.size() && furnace_angles[i] <= steepest; ++i) deviation.see(std::abs(row.albedo[i] - 1), place_of(row, i));
  return deviation;
}

}  // namespace relume
