// The objects that a material file speaks of, found in the G-buffer.
#pragma once

#include "host/materials.h"

namespace relume {

/// Finds the layer with the ids, adds it to `reading.roles`, and puts materials that are given by name to ids. `place` begins messages: the material
/// file's name. Throws Error{input} where a name is unknown, or two names are one object. A file without entries for objects needs no layer.
void find_objects(MaterialFile& materials, const ExrFile& file, Reading& reading, const std::string& place);

}  // namespace relume
