// The structs and enums that cross to the kernels, in C++: the same text, kernels/frame.h, in our namespace.
#pragma once

namespace relume {
#include "kernels/frame.h"

static_assert(sizeof(LightRecord) == 64, "one cache line; packed alike in OpenCL C and C++");
static_assert(sizeof(Field) == 3 * sizeof(int));
}  // namespace relume
