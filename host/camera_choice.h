// Which camera counts where several are to be had: the one named, the file's own, the rig's, or the one recovered from the positions; and the rigs'
// worlds set against the file's by it.
#pragma once

#include <vector>

#include "gbuffer/exr_file.h"
#include "gbuffer/reading.h"
#include "host/rig.h"

namespace relume {

/// Understands the file with the best camera there is. A rig's camera gives way to the positions' own where both are to be had and disagree
/// (stereo: a rig knows one eye), with a note. Where the two differ by an exchange of axes or a unit, a glTF rig is turned and scaled to the file's
/// world, with a note; a JSON rig, whose world is the file's by definition, only gets a warning. Error{input} where there is no camera at all.
Reading understand_with_rigs(const ExrFile& file, const ReadingOptions& options, std::vector<Rig>& rigs);

}  // namespace relume
