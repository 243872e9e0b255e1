// read_mesh: Assimp behind our own checks, with only the importers that are wanted and none of the steps that move, join or drop what the file has.
#include "bake/read_mesh.h"

#include <assimp/BaseImporter.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/Importer.hpp>
#include <assimp/ProgressHandler.hpp>

#include <algorithm>
#include <sstream>

#include "bake/assimp_scene.h"
#include "bake/vertex_normals.h"
#include "gbuffer/error.h"
#include "gbuffer/input_stream.h"
#include "gbuffer/layers.h"
#include "gbuffer/printable.h"
#include "gbuffer/watched.h"

namespace relume {
namespace {

constexpr const char* endings[] = {"obj", "ply", "stl", "gltf", "glb"};

std::string ending_of(const std::filesystem::path& file) {
  const std::string extension = lower(file.extension().string());
  return extension.empty() ? extension : extension.substr(1);
}

bool is_gltf(const std::filesystem::path& file) { return ending_of(file) == "gltf" || ending_of(file) == "glb"; }

/// Importers of other formats would be tried by content: 40 parsers that nobody asked for.
void keep_wanted_importers(Assimp::Importer& importer) {
  for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
    std::istringstream extensions(importer.GetImporter(i)->GetInfo()->mFileExtensions);
    bool wanted = false;
    for (std::string extension; extensions >> extension;)
      wanted = wanted || std::find(std::begin(endings), std::end(endings), extension) != std::end(endings);
    if (!wanted) importer.UnregisterLoader(importer.GetImporter(i));
  }
}

class Beats : public Assimp::ProgressHandler {
 public:
  bool Update(float) override {
    beat();
    return true;
  }
};

std::string why_not(const Assimp::Importer& importer) {
  const std::string text = importer.GetErrorString();
  return text.empty() ? "nothing in it" : printable(text.substr(0, text.find('\n')));
}

const aiScene& scene_of(Assimp::Importer& importer, const std::filesystem::path& file, const std::string& name) {
  keep_wanted_importers(importer);
  importer.SetProgressHandler(new Beats);  // the importer's to delete
  const InForeignCode reading(Foreign::mesh, name);
  const aiScene* scene = importer.ReadFile(file.string(), 0);
  if (!scene || !scene->mRootNode) throw Error(ErrorKind::input, name + ": not a mesh that can be read: " + why_not(importer));
  return *scene;
}

const aiScene* triangulated(Assimp::Importer& importer, const std::string& name) {
  const InForeignCode cutting(Foreign::mesh, name);
  return importer.ApplyPostProcessing(aiProcess_Triangulate);
}

/// (x, y, z) becomes (x, -z, y) where a mesh with y up enters a world with z up, and back.
glm::dmat4 world_from_file(const std::filesystem::path& file, const MeshOptions& options) {
  using Up = MeshOptions::Up;
  const Up mesh_up = options.mesh_up == Up::as_stored || is_gltf(file) ? Up::y : options.mesh_up;  // glTF 2.0, 3.3: y is up
  if (options.world_up == Up::as_stored || options.world_up == mesh_up) return glm::dmat4(1);
  if (options.world_up == Up::z) return {{1, 0, 0, 0}, {0, 0, 1, 0}, {0, -1, 0, 0}, {0, 0, 0, 1}};
  return {{1, 0, 0, 0}, {0, 0, -1, 0}, {0, 1, 0, 0}, {0, 0, 0, 1}};
}

void make_normals(Mesh& mesh, MeshOptions::Normals wanted) {
  const bool stored = std::any_of(mesh.vertices.begin(), mesh.vertices.end(), [](const MeshVertex& v) { return v.normal != glm::dvec3(0); });
  if (wanted == MeshOptions::Normals::flat) return make_flat_normals(mesh);
  if (wanted == MeshOptions::Normals::smooth) return make_smooth_normals(mesh);
  if (!stored) {
    mesh.notes.emplace_back("the file has no normals: smooth ones are made from the triangles around each vertex (--normals flat: facets)");
    return make_smooth_normals(mesh);
  }
  if (const std::size_t mended = mend_normals(mesh); mended > 0)
    mesh.notes.push_back("warning: " + std::to_string(mended) + " vertices have a normal that is no direction: their triangle's is taken");
}

}  // namespace

bool is_mesh_name(const std::filesystem::path& file) {
  return std::find(std::begin(endings), std::end(endings), ending_of(file)) != std::end(endings);
}

Mesh read_mesh(const std::filesystem::path& file, const MeshOptions& options) {
  const std::string name = InputStream(file).name();  // refuses what is not there, and what is no file
  if (!is_mesh_name(file)) throw Error(ErrorKind::input, name + ": not a mesh by its name (ends in .obj, .ply, .stl, .gltf or .glb)");
  Assimp::Importer importer;
  const aiScene& read = scene_of(importer, file, name);
  Mesh mesh;
  mesh.has_camera = read.HasCameras();
  if (read.HasAnimations()) mesh.notes.emplace_back("animations are not played: every node stands where the file has it at rest");
  check_faces(const_cast<aiScene&>(read), name);  // the importer keeps it, to be worked on in place
  const aiScene* const triangles = triangulated(importer, name);
  if (!triangles) throw Error(ErrorKind::input, name + ": its faces cannot be cut into triangles: " + why_not(importer));
  take_geometry(*triangles, world_from_file(file, options), {std::max(triangles->mNumMaterials, 1U), is_gltf(file)}, name, mesh);
  if (mesh.triangles.empty()) throw Error(ErrorKind::input, name + ": has no triangles (points, lines and faces without area are not baked)");
  take_materials(*triangles, file, mesh);
  make_normals(mesh, options.normals);
  return mesh;
}

}  // namespace relume
