// The white furnace test: what reflects all light in one bounce or many cannot be told from the furnace around it, from any direction.
#include <algorithm>

#include "lab/furnace.h"
#include "lab/laws/list.h"

namespace relume {

/// With the arguments set; a setting that contradicts a "distribution=..." among them is not tried.
Deviation law_white(const Examined& lobe, const std::vector<std::string>& arguments) {
  Deviation deviation;
  std::vector<Setting> settings;
  for (const Setting& setting : lobe.grid) {
    const std::string wanted = value_in(arguments, "distribution");
    if (wanted.empty() || value_in(setting, "distribution") == wanted) settings.push_back(with_others(setting, arguments));
  }
  std::sort(settings.begin(), settings.end());
  settings.erase(std::unique(settings.begin(), settings.end()), settings.end());
  for (const FurnaceRow& row : furnace(lobe, settings))
    for (std::size_t i = 0; i < row.albedo.size(); ++i) deviation.see(std::abs(row.albedo[i] - 1), place_of(row, i));
  return deviation;
}

}  // namespace relume
