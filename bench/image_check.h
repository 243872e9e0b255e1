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

}  // namespace relume::bench
