// Normals for a file that has none: those of the surface through neighbouring positions, kept apart at edges.
#pragma once

#include "gbuffer/exr_file.h"
#include "gbuffer/reading.h"

namespace relume {

/// World positions of a window, row by row; infinite or NaN where nothing is seen. Made from depth where the file has no positions.
std::vector<glm::dvec3> world_positions(const ExrFile& file, const Reading& reading, const Window& window);

/// Three planes, `stride` floats apart.
struct NormalPlanes {
  float* first;
  std::size_t stride;
};

/// Facing the viewer, unit length, in the world; zero where no neighbour lies on the same surface. In each image direction the side whose two
/// differences agree is taken, so that no normal straddles an edge. Reads 2 pixels beyond the window, so that bands agree with the whole.
void make_normals(const ExrFile& file, const Reading& reading, const Window& window, const NormalPlanes& to);

}  // namespace relume
