// One compilation of the kernels as C++, for one lane count: included by twin_1.cpp ... twin_16.cpp, each built for the processor it needs.
#include <cmath>
#include <cstddef>
#include <cstring>

#include "host/culling.h"
#include "host/frame.h"
#include "kernels/entries.h"

#define RELUME_TWIN_JOIN_(a, b) a##b
#define RELUME_TWIN_JOIN(a, b) RELUME_TWIN_JOIN_(a, b)

namespace relume {
namespace RELUME_TWIN_JOIN(lanes, RELUME_LANES) {
  namespace {
#include "host/near_lanes.h"
#include "kernels/bounds.h"
#include "kernels/directions.h"
#include "kernels/environment_prefiltered.h"
#include "kernels/environment_sampled.h"
#include "kernels/evaluate.h"
#include "kernels/shade.h"
#include "kernels/terms.h"
  }  // namespace

#define RELUME_RANGE(name)                                                                                                                           \
  void name##_range(const Choice& choice, const float* planes, const Frame& frame, const LightRecord* lights, const int* lists, const float* tables, \
                    float* out, int first, int last) {                                                                                               \
    for (int i = first; i < last; i += RELUME_LANES) name##_pixels(choice, planes, &frame, lights, lists, tables, out, i);                           \
  }
  /// Each kernel over pixels [first, last), first a multiple of the lanes.
  RELUME_ENTRIES(RELUME_RANGE)
#undef RELUME_RANGE

  static int bound_cell(const float* planes, const Frame& frame, const int* blocks, int count, float widest, PixelBounds* parts) {
    return bound_parts(planes, &frame, blocks, count, widest, parts);
  }
  extern const Culling culling{bound_cell, places_near, numbers_lighting};
}  // namespace )
}  // namespace relume
