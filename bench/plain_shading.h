// The yardstick: shading as one would write it in C++ without thinking of devices: textbook formulas with the half vector, std::exp, one loop over
// pixels and one over lights, left to the compiler (-O3 -march=native -ffast-math, OpenMP simd).
#pragma once

namespace relume::bench {

/// Structure of arrays, as any renderer's G-buffer is once it is read.
struct PlainPixels {
  const float *position[3], *normal[3], *albedo[3], *alpha;
  float* out[3];
  float eye[3];
};

struct PlainLights {
  const float *position[3], *intensity[3];
  int count;
};

enum class PlainBrdf { lambert, cook_torrance, ggx };  ///< the latter two over Lambert

/// Pixels [first, last) under all lights, on this thread.
void shade_plainly(PlainBrdf brdf, const PlainPixels& pixels, const PlainLights& lights, int first, int last);

}  // namespace relume::bench
