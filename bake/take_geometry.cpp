// take_geometry: nodes walked depth first in the file's order, so that triangles keep the order that the file has them in.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <span>
#include <string_view>
#include <unordered_map>

#include "bake/assimp_scene.h"
#include "gbuffer/error.h"
#include "gbuffer/printable.h"

namespace relume {
namespace {

glm::dmat4 matrix_of(const aiMatrix4x4& m) {
  return {{m.a1, m.b1, m.c1, m.d1}, {m.a2, m.b2, m.c2, m.d2}, {m.a3, m.b3, m.c3, m.d3}, {m.a4, m.b4, m.c4, m.d4}};
}

bool finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

float linear_of(float encoded) { return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f); }

struct BitsHash {
  std::size_t operator()(const std::array<float, 11>& v) const {
    return std::hash<std::string_view>()({reinterpret_cast<const char*>(v.data()), sizeof v});
  }
};
struct BitsEqual {
  bool operator()(const std::array<float, 11>& a, const std::array<float, 11>& b) const { return std::memcmp(a.data(), b.data(), sizeof a) == 0; }
};

/// One of Assimp's meshes at one node.
class MeshAtNode {
 public:
  MeshAtNode(const aiMesh& from, const glm::dmat4& world_from_node, const SceneKind& kind, const std::string& name, Mesh& to)
      : from_(from), world_from_node_(world_from_node), kind_(kind), name_(name), to_(to) {}

  /// Triangles to the mesh, of this object; how many faces were points or lines.
  std::size_t add(std::uint32_t object) {
    const bool mirrored = glm::determinant(glm::dmat3(world_from_node_)) < 0;  // what was counter-clockwise is clockwise then
    std::size_t left_out = 0;
    for (const aiFace& face : std::span(from_.mFaces, from_.mNumFaces)) {
      if (face.mNumIndices != 3) {
        ++left_out;
        continue;
      }
      MeshTriangle triangle{{vertex(face.mIndices[0]), vertex(face.mIndices[1]), vertex(face.mIndices[2])},
                            object,
                            std::min(from_.mMaterialIndex, kind_.materials - 1)};
      if (mirrored) std::swap(triangle.vertices[1], triangle.vertices[2]);
      to_.triangles.push_back(triangle);
    }
    return left_out;
  }

 private:
  std::array<float, 11> stored(unsigned i) const {
    const aiVector3D none, &p = from_.mVertices[i], &n = from_.HasNormals() ? from_.mNormals[i] : none;
    const aiVector3D& t = from_.HasTextureCoords(0) ? from_.mTextureCoords[0][i] : none;
    const aiColor4D white(1, 1, 1, 1), &c = from_.HasVertexColors(0) ? from_.mColors[0][i] : white;
    return {p.x, p.y, p.z, n.x, n.y, n.z, t.x, t.y, c.r, c.g, c.b};
  }

  std::uint32_t vertex(unsigned i) {
    const std::array<float, 11> bits = stored(i);
    const auto [known, is_new] = known_.try_emplace(bits, std::uint32_t(to_.vertices.size()));
    if (!is_new) return known->second;
    MeshVertex v;
    v.position = glm::dvec3(world_from_node_ * glm::dvec4(bits[0], bits[1], bits[2], 1));
    constexpr double largest = 1e18;  // its square is a number in single precision, which the lights' distances are taken in
    if (!finite(v.position) || glm::length(v.position) > largest)
      throw Error(ErrorKind::input, name_ + ": mesh \"" + printable(from_.mName.C_Str()) + "\": vertex " + std::to_string(i) +
                                        " is not a place (coordinates are numbers up to 1e18)");
    v.normal = normals_ * glm::dvec3(bits[3], bits[4], bits[5]);
    v.uv = {std::isfinite(bits[6]) ? bits[6] : 0, std::isfinite(bits[7]) ? bits[7] : 0};
    for (int c = 0; c < 3; ++c) {
      const float value = std::clamp(std::isfinite(bits[std::size_t(8 + c)]) ? bits[std::size_t(8 + c)] : 1.0f, 0.0f, 1.0f);
      v.colour[c] = kind_.linear_colours ? value : linear_of(value);
    }
    to_.vertices.push_back(v);
    return known->second;
  }

  const aiMesh& from_;
  const glm::dmat4 world_from_node_;
  const glm::dmat3 normals_ = glm::transpose(glm::inverse(glm::dmat3(world_from_node_)));
  const SceneKind& kind_;
  const std::string& name_;
  Mesh& to_;
  std::unordered_map<std::array<float, 11>, std::uint32_t, BitsHash, BitsEqual> known_;
};

/// A node and where its parent stands.
struct Visit {
  const aiNode* node;
  glm::dmat4 world_from_parent;
};

void note_left_out(std::size_t faces, const char* what, Mesh& mesh) {
  if (faces > 0) mesh.notes.push_back(std::to_string(faces) + " " + what);
}

/// Triangles without an area have no normal and no pixel.
std::size_t drop_degenerate(Mesh& mesh) {
  return std::erase_if(mesh.triangles, [&](const MeshTriangle& triangle) {
    const double area = glm::length(area_normal(mesh, triangle));
    return !(area > 0) || !std::isfinite(area);
  });
}

}  // namespace

void check_faces(aiScene& scene, const std::string& name) {
  for (aiMesh* const mesh : std::span(scene.mMeshes, scene.mNumMeshes)) {
    for (const aiFace& face : std::span(mesh->mFaces, mesh->mNumFaces))
      for (const unsigned i : std::span(face.mIndices, face.mNumIndices))
        if (i >= mesh->mNumVertices)
          throw Error(ErrorKind::input, name + ": mesh \"" + printable(mesh->mName.C_Str()) + "\": a face names vertex " + std::to_string(i) +
                                            " (there are " + std::to_string(mesh->mNumVertices) + ")");
    const auto end = std::remove_if(mesh->mFaces, mesh->mFaces + mesh->mNumFaces, [](const aiFace& face) { return face.mNumIndices == 0; });
    mesh->mNumFaces = unsigned(end - mesh->mFaces);
    if (std::none_of(mesh->mFaces, end, [](const aiFace& face) { return face.mNumIndices > 3; }))
      mesh->mPrimitiveTypes &= ~unsigned(aiPrimitiveType_POLYGON);
  }
}

void take_geometry(const aiScene& scene, const glm::dmat4& world_from_file, const SceneKind& kind, const std::string& name, Mesh& mesh) {
  std::vector<Visit> visits{{scene.mRootNode, world_from_file}};
  std::size_t no_faces = 0;
  while (!visits.empty()) {
    const Visit visit = visits.back();
    visits.pop_back();
    const glm::dmat4 world_from_node = visit.world_from_parent * matrix_of(visit.node->mTransformation);
    if (visit.node->mNumMeshes > 0) mesh.objects.emplace_back(visit.node->mName.C_Str());
    for (const unsigned index : std::span(visit.node->mMeshes, visit.node->mNumMeshes)) {
      const aiMesh& from = *scene.mMeshes[index];
      mesh.has_uv = mesh.has_uv || from.HasTextureCoords(0);
      mesh.has_albedo = mesh.has_albedo || from.HasVertexColors(0);
      no_faces += MeshAtNode(from, world_from_node, kind, name, mesh).add(std::uint32_t(mesh.objects.size() - 1));
    }
    for (unsigned c = visit.node->mNumChildren; c-- > 0;) visits.push_back({visit.node->mChildren[c], world_from_node});
  }
  note_left_out(no_faces, "points and lines are left out: only faces are baked", mesh);
  note_left_out(drop_degenerate(mesh), "triangles have no area and are left out", mesh);
}

}  // namespace relume
