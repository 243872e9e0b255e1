// A band's cells and what bounds them, which does not change with the lights: kept from one listing of lights to the next.
#pragma once

#include <optional>

#include "host/cell_bounds.h"

namespace relume {

class FrameBounds {
 public:
  /// `planes` and `frame` outlive it, where they are; rows are `width` long.
  FrameBounds(const Planes& planes, const Frame& frame, int width) : pixels_(planes, frame, width) {}

  const PixelCells& pixels() const { return pixels_; }
  /// Boxes longer than `widest` are split: made anew only where the last ones were split at another length.
  const CellBounds& split_at(float widest);
  /// The last ones, split wherever it may be.
  const CellBounds& last();

 private:
  PixelCells pixels_;
  std::optional<CellBounds> bounds_;
  float widest_ = 0;
};

}  // namespace relume
