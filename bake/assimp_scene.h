// What Assimp read, taken over into a Mesh. For bake/read_mesh.cpp alone.
#pragma once

#include <assimp/scene.h>

#include <filesystem>
#include <glm/mat4x4.hpp>

#include "bake/mesh.h"

namespace relume {

/// What is known of the scene beside its nodes.
struct SceneKind {
  unsigned materials = 1;       ///< how many take_materials() makes
  bool linear_colours = false;  ///< of vertices: glTF's; PLY's and OBJ's are on the sRGB curve, as what writes them shows them
};

/// Makes faces such that Assimp's own steps can work on them: importers pass on what a file claims. Those without vertices go, and no mesh says that
/// it has polygons where it has none, for both end the program there; a face that names a vertex which is not there is Error{input}.
void check_faces(aiScene& scene, const std::string& name);

/// Every node's meshes, each where its node has it. Vertices alike in all they hold become one. Error{input}, with `name` as its place, for
/// coordinates that are no numbers.
void take_geometry(const aiScene& scene, const glm::dmat4& world_from_file, const SceneKind& kind, const std::string& name, Mesh& mesh);

/// Albedo, roughness and metallic, with their textures; pictures are looked for beside `file`. One that cannot be read is a note.
void take_materials(const aiScene& scene, const std::filesystem::path& file, Mesh& mesh);

}  // namespace relume
