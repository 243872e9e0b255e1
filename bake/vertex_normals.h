// Normals for vertices that a file gives none.
#pragma once

#include "bake/mesh.h"

namespace relume {

/// Vertices of one object at one place share the mean of the triangles around them, weighted by angle.
void make_smooth_normals(Mesh& mesh);

/// Each triangle has vertices, and a normal, of its own.
void make_flat_normals(Mesh& mesh);

/// Vertices whose normal is no direction get that of a triangle that they belong to; how many there were.
std::size_t mend_normals(Mesh& mesh);

}  // namespace relume
