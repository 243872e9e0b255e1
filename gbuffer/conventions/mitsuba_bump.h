// How Mitsuba's shading normals relate to its geometric ones: bump and normal maps, smooth meshes, the frame that sh_normal is written in.
#pragma once

#include "gbuffer/reading.h"

namespace relume {

class Samples;

/// Decides from the data, shape by shape, and notes every verdict with its count. Without a geo_normal layer there is nothing to decide by.
void settle_mitsuba_bump(Samples& samples, const ReadingOptions& options, Reading& reading);

}  // namespace relume
