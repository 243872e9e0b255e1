// Which camera a G-buffer was seen with: given, stated by the header and borne out by the positions, or recovered from them.
#pragma once

#include "gbuffer/reading.h"

namespace relume {

class Samples;

/// Sets reading.camera, or adds a note that says why there is none. A camera that the convention has already set counts as the header's.
void find_camera(Samples& samples, const ReadingOptions& options, Reading& reading);

}  // namespace relume
