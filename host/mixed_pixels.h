// Pixels of a frame that mix surfaces: what became of them, and the light of their surfaces put together.
#pragma once

#include <cstdint>
#include <string>

#include "gbuffer/gbuffer.h"

namespace relume {

/// Sums over bands of what Mixtures counts.
class MixedPixels {
 public:
  void add(const Mixtures& mixtures);
  /// How many of the frame's pixels, and how they were shaded; empty if there are none.
  std::string sentence(std::int64_t surface_pixels) const;

 private:
  std::int64_t apart_ = 0, partial_ = 0, unexplained_ = 0;
};

/// Adds the light of a pixel's further surfaces to its own; each is weighted by its coverage already.
void fold_surfaces(const GBuffer& gbuffer, Planes& out);

}  // namespace relume
