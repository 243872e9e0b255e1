// Which camera counts where several are to be had: the one named, the file's own, the rig's, or the one recovered from the positions.
#pragma once

#include <optional>

#include "gbuffer/exr_file.h"
#include "gbuffer/reading.h"

namespace relume {

/// Understands the file with the best camera there is. A rig's camera gives way to the positions' own where both are to be had and disagree
/// (stereo: a rig knows one eye), with a note. Error{input} where there is none at all.
Reading understand_with_camera(const ExrFile& file, const ReadingOptions& options, const std::optional<Camera>& rig_camera);

}  // namespace relume
