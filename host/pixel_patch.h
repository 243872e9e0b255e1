// Pixels that a light tree is cut for together: neighbours in space with one program, and what bounds them.
#pragma once

#include <vector>

#include "host/pixel_cells.h"

namespace relume {

/// A cone of unit directions.
struct DirectionCone {
  float axis[3], cosine, sine;  ///< of its half-angle
};

struct PixelPatch {
  int program;
  bool highlights;             ///< the viewer is in front: the specular lobe is seen
  float centre[3], radius;     ///< of a ball around the positions
  DirectionCone normal, view;  ///< as shaded
  float n_v_low, n_v_high;
  float low[FIELD_COUNT][3], high[FIELD_COUNT][3];  ///< of the lobes' parameters
};

/// The patches of the pixels of `rows` rows of blocks from row y, one block wide: split where the surface jumps in depth, and where a component of
/// its normals spreads over more than `most_turn`. Pixels on which no light is seen are in none. Appended to `patches`.
void add_patches(const PixelCells& pixels, int y, int column, int rows, float most_turn, std::vector<PixelPatch>& patches);

}  // namespace relume
