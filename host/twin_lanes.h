// One compilation of the kernels as C++, for one lane count: included by twin_1.cpp ... twin_16.cpp, each built for the processor it needs.
#include <cmath>
#include <cstddef>
#include <cstring>

#include "host/frame.h"

#define RELUME_TWIN_JOIN_(a, b) a##b
#define RELUME_TWIN_JOIN(a, b) RELUME_TWIN_JOIN_(a, b)

namespace relume {
namespace RELUME_TWIN_JOIN(lanes, RELUME_LANES) {
  namespace {
#include "kernels/bounds.h"
#include "kernels/evaluate.h"
#include "kernels/shade.h"
  }  // namespace

  /// Pixels [first, last), first a multiple of the lanes; see kernels/shade.h.
  void shade_range(const Choice& choice, const float* planes, const Frame& frame, const LightRecord* lights, const int* lists, const float* tables,
                   float* out, int first, int last) {
    for (int i = first; i < last; i += RELUME_LANES) shade_pixels(choice, planes, &frame, lights, lists, tables, out, i);
  }

  /// See kernels/bounds.h.
  void bound_cell(const float* planes, const Frame& frame, const int* blocks, int count, PixelBounds& bounds) {
    bound_blocks(planes, &frame, blocks, count, &bounds);
  }

  /// Rows [first, last); see kernels/evaluate.h.
  void evaluate_range(const Choice& choice, const float* planes, const Frame& frame, const float* tables, float* out, int first, int last) {
    for (int i = first; i < last; i += RELUME_LANES) evaluate_rows(choice, planes, &frame, tables, out, i);
  }
}  // namespace )
}  // namespace relume
