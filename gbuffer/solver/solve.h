// Settles from the data what names and header leave open, in the order of gbuffer/solver/list.h.
#pragma once

#include "gbuffer/reading.h"

namespace relume {

class Samples;

/// What has to be known before a camera can be sought: the encoding of normals, the space of positions.
void solve_before_camera(Samples& samples, const ReadingOptions& options, Reading& reading);

/// What the camera helps to tell: premultiplication, the kind of depth, the space and axes of normals.
void solve_with_camera(Samples& samples, const ReadingOptions& options, Reading& reading);

}  // namespace relume
