// furnace: all angles of a setting in one integration.
#include "lab/furnace.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace relume {

std::vector<FurnaceRow> furnace(const Examined& lobe, const std::vector<Setting>& settings, double tolerance) {
  std::vector<double> cosines;
  for (const double angle : furnace_angles) cosines.push_back(std::cos(angle * std::numbers::pi / 180));
  std::vector<FurnaceRow> rows;
  for (const Setting& setting : settings) {
    rows.push_back({setting, {}, {}});
    const std::vector<LobeAlbedos> albedos = directional_albedos(lobe.with(setting), cosines, tolerance);
    for (std::size_t i = 0; i < albedos.size(); ++i) {
      const Albedo total = albedos[i].total();
      rows.back().albedo[i] = std::max({total.value.x, total.value.y, total.value.z});
      rows.back().error[i] = std::max({total.error.x, total.error.y, total.error.z});
    }
  }
  return rows;
}

std::string place_of(const FurnaceRow& row, std::size_t angle) {
  char text[40];
  std::snprintf(text, sizeof text, ", view %g degrees", furnace_angles[angle]);
  return text_of(row.setting) + text;
}

}  // namespace relume
