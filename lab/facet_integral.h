// Integrals over the facets h of a rough surface, of what they show when light and viewer are along h.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "lab/brdf.h"

namespace relume {

/// One value for each pair, l = v = h.
using FacetValues = std::function<std::vector<double>(std::span<const DirectionPair>)>;

/// The integral of value(h) n.h over the hemisphere; distributions as narrow as 1e-4 are met.
double projected_area(const FacetValues& values);

}  // namespace relume
