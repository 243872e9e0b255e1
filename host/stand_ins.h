// What stands in for a cluster of lights, made from the moments of their intensities.
#pragma once

#include <span>
#include <vector>

#include "host/light_tree.h"

namespace relume {

/// Fills the cluster's ball, intensity, `one` and `four` (whose `first` is left open). Returns the stand-ins' records: of `one`, then of `four`.
std::vector<LightRecord> find_stand_ins(LightCluster& cluster, std::span<const LightRecord> records, std::span<const int> lights);

}  // namespace relume
