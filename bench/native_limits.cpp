// Built for this very processor (-march=native, contraction on: bench/CMakeLists.txt), so it includes no header whose inline functions others share.
#include "bench/native_limits.h"

namespace relume::bench {
namespace {

typedef float Vector __attribute__((vector_size(64), aligned(4)));

Vector at(const float* p) {
  Vector x;
  __builtin_memcpy(&x, p, sizeof x);
  return x;
}

float sum_of(Vector x) {
  float sum = 0;
  for (int lane = 0; lane < 16; ++lane) sum += x[lane];
  return sum;
}

}  // namespace

float native_chains(int steps) {
  Vector x[12], factor = Vector{} + 0.999f, addend = Vector{} + 0.001f;
  for (int k = 0; k < 12; ++k) x[k] = Vector{} + float(k);
  asm volatile("" : "+m"(factor), "+m"(addend));  // unknown to the compiler, or it would do the chains' sums itself
  const Vector f = factor, a = addend;
  for (int i = 0; i < steps; ++i) {
    for (int k = 0; k < 12; ++k) x[k] = x[k] * f + a;
  }
  for (int k = 1; k < 12; ++k) x[0] += x[k];
  return sum_of(x[0]);
}

float native_read(const float* a, std::size_t floats) {
  Vector sums[4] = {};
  for (std::size_t i = 0; i + 64 <= floats; i += 64)
    for (int k = 0; k < 4; ++k) sums[k] += at(a + i + 16 * std::size_t(k));
  return sum_of(sums[0] + sums[1] + sums[2] + sums[3]);
}

void native_copy(const float* __restrict a, float* __restrict c, std::size_t floats) {
  for (std::size_t i = 0; i < floats; ++i) c[i] = a[i];
}

void native_triad(const float* __restrict a, const float* __restrict b, float* __restrict c, std::size_t floats) {
  for (std::size_t i = 0; i < floats; ++i) c[i] = a[i] + 3.0f * b[i];
}

}  // namespace relume::bench
