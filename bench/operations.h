// What the shading formulas cost: the operations that a pixel and a light need, counted from the kernels' own source.
#pragma once

#include "gbuffer/planes.h"
#include "host/device.h"

namespace relume::bench {

/// Each once, however many lanes do it side by side.
struct Operations {
  double add = 0, multiply = 0, divide = 0, root = 0;  ///< floating-point arithmetic: one flop each
  double fused = 0;                                    ///< of these, pairs of a multiplication and an addition in one operation
  double compare = 0, select = 0, whole = 0;           ///< comparisons, choices between two values, and whole-number or bit operations: no flops
  double loads = 0, stores = 0;                        ///< of 4 bytes, from and to the planes

  double flops() const { return add + multiply + divide + root; }
  double bytes() const { return 4 * (loads + stores); }
};

struct ShadingCost {
  Operations pixel;  ///< what does not depend on the light
  Operations light;  ///< one light more, of the same type as the first
};

/// The cost of shading a pixel of the frame with the lobes of `choice` under lights like the first of `data`, where they shine on it: what the result
/// needs, each distinct operation once.
ShadingCost count_operations(const Choice& choice, const Frame& frame, const BandData& data);

}  // namespace relume::bench
