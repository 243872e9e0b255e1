// A layer's numbers over a window, in memory.
#pragma once

#include <vector>

#include "gbuffer/exr_file.h"
#include "gbuffer/reading.h"

namespace relume {

/// Row by row, a pixel's components side by side. Throws Error{input}, as ExrFile::read does.
std::vector<float> layer_values(const ExrFile& file, const RoleLayer& layer, const Window& window);

}  // namespace relume
