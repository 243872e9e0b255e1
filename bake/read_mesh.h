// Meshes from OBJ, PLY, STL, glTF and GLB, through Assimp.
#pragma once

#include <filesystem>

#include "bake/mesh.h"

namespace relume {

struct MeshOptions {
  enum class Normals {
    stored,  ///< the file's; where it has none, smooth ones with a note
    smooth,  ///< made from the triangles around each vertex
    flat     ///< each triangle's own
  };
  enum class Up { as_stored, y, z };
  Normals normals = Normals::stored;
  Up mesh_up = Up::as_stored, world_up = Up::as_stored;  ///< the mesh is turned where both are known and differ; glTF's is y
};

/// Whether the file's name ends as a mesh's does.
bool is_mesh_name(const std::filesystem::path& file);

/// Error{input} for what is no mesh, has no triangle, or coordinates that are no numbers.
Mesh read_mesh(const std::filesystem::path& file, const MeshOptions& options);

}  // namespace relume
