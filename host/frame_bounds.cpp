// FrameBounds: made when asked for.
#include "host/frame_bounds.h"

#include <limits>

namespace relume {

const CellBounds& FrameBounds::split_at(float widest) {
  if (!bounds_ || widest != widest_) bounds_.emplace(pixels_, widest_ = widest);
  return *bounds_;
}

const CellBounds& FrameBounds::last() { return bounds_ ? *bounds_ : split_at(std::numeric_limits<float>::infinity()); }

}  // namespace relume
