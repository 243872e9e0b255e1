// Lists are read as the pixels are: what was found out of those holds for them, and their neighbours tell nothing.
#include "gbuffer/mesh_parts.h"

#include <algorithm>

#include "gbuffer/error.h"
#include "gbuffer/printable.h"

namespace relume {

const Part& mesh_part(const ExrFile& file, const std::string& name) {
  const auto found = std::find_if(file.parts().begin(), file.parts().end(), [&](const Part& part) { return part.name == name; });
  if (found == file.parts().end())
    throw Error(ErrorKind::input,
                printable(file.path().native()) + ": no part \"" + name + "\" (relume bake writes one; --interpolation phong needs none)");
  return *found;
}

Reading reading_of_part(const Reading& pixels, const ExrFile& file, const Part& part) {
  Reading reading = pixels;
  reading.part = part.index;
  reading.data_window = part.data_window;
  reading.filtered = reading.position_premultiplied = false;  // a list has no pixels that mix surfaces
  reading.roles.erase("depth");                               // nor a depth
  reading.roles.erase("primitive_ids");
  for (auto& [role, layer] : reading.roles) {
    layer.part = part.index;
    for (const std::string& channel : layer.channels)
      if (!part.has_channel(channel))
        throw Error(ErrorKind::input, printable(file.path().native()) + ": part \"" + part.name + "\" has no channel \"" + printable(channel) +
                                          "\", which " + printable(role) + " is read from (--interpolation phong shades the pixels)");
  }
  return reading;
}

}  // namespace relume
