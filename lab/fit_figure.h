// Slices of a measured table with the BRDFs that were fitted to it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "figure/figure.h"
#include "lab/fit.h"

namespace relume {

/// f_r against theta_h (the highlight) and against theta_d (Fresnel's effect, and grazing angles), in luminance; the first four fits, best first. A
/// grey line marks the angle beyond which light and view are further than `grazing` degrees from the normal, where nothing was fitted.
Figure fit_figure(const MerlTable& table, const std::vector<Fit>& fits, double grazing, const std::string& title,
                  const std::shared_ptr<Device>& device);

}  // namespace relume
