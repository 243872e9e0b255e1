// Rows of half floats to floats and back, by the processor's own instructions where it has them (F16C, eight at a time), else by Imath: the same
// numbers.
#pragma once

#include <half.h>

#include <cstddef>

namespace relume {

void floats_of(const half* from, float* to, std::size_t count);

/// Rounds to the nearest, of two equals to the even one. What is finite stays so: beyond half's range it becomes the largest half, for a bright
/// highlight that is a number is something that filters and denoisers can use.
void halves_of(const float* from, half* to, std::size_t count);

}  // namespace relume
