// What a baked file's header says of its mesh and its camera.
#pragma once

#include <ImfHeader.h>

#include "bake/bake.h"

namespace relume {

/// OpenEXR's worldToCamera and worldToNDC, the program's mark, the mesh's name and those of its objects.
Imf::Header header_of(const BakeJob& job, const Mesh& mesh);

}  // namespace relume
