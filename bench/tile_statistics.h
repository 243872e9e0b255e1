// How much work a frame under ranged lights holds: what is left of it by tiles, and what lights anything at all.
#pragma once

#include "gbuffer/gbuffer.h"
#include "host/rig.h"

namespace relume::bench {

struct TileStatistics {
  double brute = 0;     ///< surface pixels times lights
  double culled = 0;    ///< surface pixels times the lights whose sphere meets the box of their tile's positions; tiles of 16x16 pixels
  double in_range = 0;  ///< pairs nearer than the light's range
  double mean_lights = 0, most_lights = 0;  ///< of a tile that shows a surface, after culling
};

TileStatistics tile_statistics(const GBuffer& frame, const std::vector<Light>& lights);

}  // namespace relume::bench
