// The twin: the kernels compiled as C++. The reference that every device is checked against, and a device for machines without OpenCL.
#pragma once

#include <memory>
#include <vector>

#include "host/device.h"

namespace relume {

/// Lane counts that this machine's processor can run, ascending: always 1 and 4, 8 with AVX2, 16 with AVX-512.
std::vector<int> twin_lanes();

/// `lanes`: 0 for the widest. Throws Error{device} that lists what there is.
std::unique_ptr<Device> open_twin(int lanes = 0);

}  // namespace relume
