// What the processor does at best from C++: the same three questions as bench/device_limits.cl.
#pragma once

#include <cstddef>

namespace relume::bench {

/// 12 chains of `steps` multiply-adds over vectors of 64 bytes on this thread; their sum, so that nothing is left out. 24 * 16 * steps flops.
float native_chains(int steps);
constexpr double native_chain_flops = 12 * 16 * 2;  ///< in a step

float native_read(const float* a, std::size_t floats);
void native_copy(const float* a, float* c, std::size_t floats);
void native_triad(const float* a, const float* b, float* c, std::size_t floats);

}  // namespace relume::bench
