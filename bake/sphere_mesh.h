// Spheres of any fineness: an icosahedron, each triangle cut into equal ones, vertices and normals on the sphere.
#pragma once

#include "bake/mesh.h"

namespace relume {

/// Each edge of the icosahedron is cut into `cuts` pieces: 20 cuts^2 triangles. Unit radius around the origin.
Mesh sphere_mesh(int cuts);

/// The mean length of the edges: what density is measured by.
double mean_edge(const Mesh& mesh);

}  // namespace relume
