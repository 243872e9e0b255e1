// Triangles seen from behind are turned round, so that normals lie on the side that is seen.
#pragma once

#include "bake/mesh.h"
#include "bake/viewing_rays.h"

namespace relume {

/// Every triangle's front faces the viewer afterwards. A vertex that triangles of both sides share becomes two, with opposite normals.
void turn_to_viewer(Mesh& mesh, const ViewingRays& rays);

}  // namespace relume
