// The ratios of the units of length that scenes are modelled in: what a scale between two worlds most likely is.
#pragma once

#include <optional>

namespace relume {

/// The ratio of two such units that comes nearest to `scale`, if within `tolerance` of it (relative).
std::optional<double> unit_ratio_near(double scale, double tolerance);

}  // namespace relume
