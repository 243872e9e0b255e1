// A lobe in a white furnace: its directional albedo from straight on to grazing, with each of its settings.
#pragma once

#include <vector>

#include "lab/examined.h"

namespace relume {

/// One row for each of the settings. `tolerance` as for directional_albedos.
std::vector<FurnaceRow> furnace(const Examined& lobe, const std::vector<Setting>& settings, double tolerance = 1e-5);

/// "alpha=0.5, view 80 degrees"
std::string place_of(const FurnaceRow& row, std::size_t angle);

}  // namespace relume
