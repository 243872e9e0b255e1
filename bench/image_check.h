// Does the device make the twin's image of this very frame? Asked before anything is timed: the speed of a wrong image is of no interest.
#pragma once

#include <string>

#include "bench/resident_frame.h"

namespace relume::bench {

/// Shades the first `pixels` of the frame on the device and on the twin. "equal" where all bits are, else "within 3e-06" of it, the largest relative
/// difference. Throws Error{device} where they differ by more than the device's rounding allows (host/self_test.h).
std::string check_image(Device& device, const ResidentFrame& frame, int pixels);

/// The same of all pixels where lights are taken from lists; and of the first where the twin meets every light: culling may not show.
std::string check_culled_image(Device& device, const ResidentFrame& frame);

/// Where lights are met through a light tree: the largest error, as a share of each channel of each pixel, against every light, on as many blocks of
/// the frame, evenly spread, as take seconds: "within 0.0021 (1 of 7 pixels)". Throws Error{device} where it is above `error`.
std::string check_cut_image(Device& device, const ResidentFrame& frame, double error);

}  // namespace relume::bench
