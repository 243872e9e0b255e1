// What a kernel needs to know of a band of the G-buffer, whatever it is to do with it: where places, normals and the viewer are.
#pragma once

#include "gbuffer/gbuffer.h"
#include "host/frame.h"

namespace relume {

/// Without lights, lobes and parameters. The total goes to the first planes of `out`, other outputs are not wanted.
Frame band_frame(const GBuffer& gbuffer, const Reading& reading, const Planes& out);

}  // namespace relume
