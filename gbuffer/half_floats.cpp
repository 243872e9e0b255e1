// floats_of, halves_of: chosen when the program starts, for it is built for processors of any age.
#include "gbuffer/half_floats.h"

#include <algorithm>
#include <cmath>
#ifdef __x86_64__
#include <immintrin.h>
#endif

namespace relume {
namespace {

constexpr float largest = 65504;  // of half

float in_half_range(float value) { return std::isfinite(value) ? std::clamp(value, -largest, largest) : value; }

#ifdef __x86_64__

/// Every processor with AVX2 has F16C too.
const bool has_instructions = __builtin_cpu_supports("avx2");

/// As many as whole vectors hold; how many that were.
__attribute__((target("avx,f16c"))) std::size_t floats_by_eight(const half* from, float* to, std::size_t count) {
  std::size_t i = 0;
  for (; i + 8 <= count; i += 8) _mm256_storeu_ps(to + i, _mm256_cvtph_ps(_mm_loadu_si128(reinterpret_cast<const __m128i*>(from + i))));
  return i;
}

__attribute__((target("avx,f16c"))) std::size_t halves_by_eight(const float* from, half* to, std::size_t count) {
  const __m256 most = _mm256_set1_ps(largest), least = _mm256_set1_ps(-largest), infinity = _mm256_set1_ps(INFINITY);
  std::size_t i = 0;
  for (; i + 8 <= count; i += 8) {
    const __m256 value = _mm256_loadu_ps(from + i), in_range = _mm256_min_ps(most, _mm256_max_ps(least, value));  // NaN, as the second, stays
    const __m256 infinite = _mm256_cmp_ps(_mm256_andnot_ps(_mm256_set1_ps(-0.0f), value), infinity, _CMP_EQ_OQ);
    const __m256 kept = _mm256_blendv_ps(in_range, value, infinite);
    _mm_storeu_si128(reinterpret_cast<__m128i*>(to + i), _mm256_cvtps_ph(kept, _MM_FROUND_TO_NEAREST_INT));
  }
  return i;
}

#else

constexpr bool has_instructions = false;
std::size_t floats_by_eight(const half*, float*, std::size_t) { return 0; }
std::size_t halves_by_eight(const float*, half*, std::size_t) { return 0; }

#endif

}  // namespace

void floats_of(const half* from, float* to, std::size_t count) {
  for (std::size_t i = has_instructions ? floats_by_eight(from, to, count) : 0; i < count; ++i) to[i] = from[i];
}

void halves_of(const float* from, half* to, std::size_t count) {
  for (std::size_t i = has_instructions ? halves_by_eight(from, to, count) : 0; i < count; ++i) to[i] = half(in_half_range(from[i]));
}

}  // namespace relume
