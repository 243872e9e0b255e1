// Anti-aliased layers mended at the edges of objects: how much of a pixel a surface covers, and which object it belongs to.
#pragma once

#include <cstdint>
#include <vector>

#include "gbuffer/reading.h"

namespace relume {

/// Row by row over a window. A filtered id is a mean of ids, so a pixel that mixes objects takes the id of the nearest unmixed pixel within 3 pixels
/// whose normal is like its own. Coverage is the file's alpha where it has one; else, next to background, the share of that neighbour's id that is
/// left (what is missing is background's 0), or the length of the mean normal where that does not bear it out.
struct Edges {
  std::vector<float> coverage;
  std::vector<std::uint32_t> ids;  ///< empty if the file has none
};

/// Reads 3 pixels beyond the window on each side where there are some, so bands agree with the whole.
Edges mend_edges(const ExrFile& file, const Reading& reading, const Window& window);

}  // namespace relume
