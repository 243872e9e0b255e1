// take_materials: glTF's metallic-roughness (glTF 2.0, 3.9) and MTL's Kd with its PBR keys Pr and Pm, as Assimp names them.
#include <assimp/material.h>

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>

#include "bake/assimp_scene.h"
#include "gbuffer/error.h"
#include "gbuffer/printable.h"

namespace relume {
namespace {

Wrap wrap_of(aiTextureMapMode mode) {
  return mode == aiTextureMapMode_Mirror ? Wrap::mirror : mode == aiTextureMapMode_Clamp ? Wrap::clamp : Wrap::repeat;
}

/// The file's pictures, each read once.
class Textures {
 public:
  Textures(const aiScene& scene, const std::filesystem::path& folder, Mesh& mesh) : scene_(scene), folder_(folder), mesh_(mesh) {}

  /// Null where the material has none of this type, or where it cannot be read, which is noted.
  std::shared_ptr<const MeshTexture> of(const aiMaterial& material, aiTextureType type, bool colour) {
    aiString path;
    aiTextureMapMode modes[2] = {aiTextureMapMode_Wrap, aiTextureMapMode_Wrap};
    unsigned uv = 0;
    if (material.GetTexture(type, 0, &path, nullptr, &uv, nullptr, nullptr, modes) != aiReturn_SUCCESS) return nullptr;
    if (uv != 0)
      mesh_.notes.push_back("warning: texture " + quoted(path) + " wants texture coordinates of set " + std::to_string(uv) +
                            ": those of set 0 are used");
    const auto key = std::tuple(std::string(path.C_Str()), colour, modes[0], modes[1]);
    const auto [known, is_new] = read_.try_emplace(key, nullptr);
    if (is_new) known->second = read(path, colour, wrap_of(modes[0]), wrap_of(modes[1]));
    return known->second;
  }

 private:
  static std::string quoted(const aiString& text) { return '"' + printable(text.C_Str()) + '"'; }

  std::shared_ptr<const MeshTexture> read(const aiString& path, bool colour, Wrap across, Wrap down) {
    try {
      if (const aiTexture* const inside = scene_.GetEmbeddedTexture(path.C_Str())) {
        if (inside->mHeight != 0) throw Error(ErrorKind::input, "texels that are not packed as a picture");
        const std::string hint = inside->achFormatHint;
        return std::make_shared<MeshTexture>(std::span(reinterpret_cast<const unsigned char*>(inside->pcData), inside->mWidth),
                                             hint == "png" ? "png" : "jpg", colour, across, down);
      }
      return std::make_shared<MeshTexture>(folder_ / path.C_Str(), colour, across, down);
    } catch (const Error& error) {
      mesh_.notes.push_back("warning: texture " + quoted(path) + " is left out: " + error.what());
      return nullptr;
    }
  }

  const aiScene& scene_;
  const std::filesystem::path folder_;
  Mesh& mesh_;
  std::map<std::tuple<std::string, bool, aiTextureMapMode, aiTextureMapMode>, std::shared_ptr<const MeshTexture>> read_;
};

std::optional<glm::dvec3> colour_of(const aiMaterial& material, const char* key, unsigned type, unsigned index) {
  aiColor4D colour;
  if (material.Get(key, type, index, colour) != aiReturn_SUCCESS) return {};
  return glm::dvec3(colour.r, colour.g, colour.b);
}

std::optional<double> number_of(const aiMaterial& material, const char* key, unsigned type, unsigned index) {
  ai_real number = 0;
  if (material.Get(key, type, index, number) != aiReturn_SUCCESS) return {};
  return double(number);
}

/// Assimp makes one up where the file has none: it says nothing.
bool is_made_up(const aiMaterial& material) { return material.GetName() == aiString(AI_DEFAULT_MATERIAL_NAME); }

constexpr double ordinary_albedo = 0.8, ordinary_roughness = 0.5;  // kernels/parameters.h's defaults, for materials that say nothing

void take_albedo(const aiMaterial& from, Textures& textures, Mesh& mesh, MeshMaterial& to) {
  to.albedo.texture = textures.of(from, aiTextureType_BASE_COLOR, true);
  if (!to.albedo.texture) to.albedo.texture = textures.of(from, aiTextureType_DIFFUSE, true);
  auto factor = colour_of(from, AI_MATKEY_BASE_COLOR);
  if (!factor && !is_made_up(from)) factor = colour_of(from, AI_MATKEY_COLOR_DIFFUSE);
  // Many exporters leave Kd black beside a picture that they mean to be seen.
  if (to.albedo.texture && (!factor || *factor == glm::dvec3(0))) factor = glm::dvec3(1);
  to.albedo.factor = factor.value_or(glm::dvec3(mesh.has_albedo ? 1 : ordinary_albedo));  // vertices' colours stand alone
  mesh.has_albedo = mesh.has_albedo || factor;
}

/// A number and its texture, which glTF packs with another into one picture; whether the file tells any of it.
struct NumberSource {
  std::optional<double> stated;
  double ordinary;
  aiTextureType own;   ///< MTL's picture for this number alone
  int packed_channel;  ///< glTF's: roughness is green, metallic blue
};

bool take_number(const aiMaterial& from, const NumberSource& source, Textures& textures, MeshColour& to, int& channel) {
  to.texture = textures.of(from, aiTextureType_UNKNOWN, false);  // Assimp's type for glTF's packed picture
  channel = to.texture ? source.packed_channel : 0;
  if (!to.texture) to.texture = textures.of(from, source.own, false);
  to.factor = glm::dvec3(source.stated.value_or(to.texture ? 1 : source.ordinary));
  return source.stated || to.texture;
}

/// A material without pbrMetallicRoughness is white metal by the standard (glTF 2.0, 3.9.2), though its author meant something else.
void note_bare_metal(Mesh& mesh) {
  const auto bare = [](const MeshMaterial& m) {
    return !m.albedo.texture && !m.roughness.texture && m.albedo.factor == glm::dvec3(1) && m.roughness.factor.x == 1 && m.metallic.factor.x == 1;
  };
  if (mesh.has_metallic && std::any_of(mesh.materials.begin(), mesh.materials.end(), bare))
    mesh.notes.emplace_back(
        "a material says nothing, which glTF takes for rough white metal (relume shade --set metallic=0 --set albedo=0.8,0.8,0.8 says otherwise)");
}

}  // namespace

void take_materials(const aiScene& scene, const std::filesystem::path& file, Mesh& mesh) {
  Textures textures(scene, file.parent_path(), mesh);
  for (const aiMaterial* const from : std::span(scene.mMaterials, scene.mNumMaterials)) {
    MeshMaterial to;
    take_albedo(*from, textures, mesh, to);
    const NumberSource roughness{number_of(*from, AI_MATKEY_ROUGHNESS_FACTOR), ordinary_roughness, aiTextureType_DIFFUSE_ROUGHNESS, 1};
    const NumberSource metallic{number_of(*from, AI_MATKEY_METALLIC_FACTOR), 0, aiTextureType_METALNESS, 2};
    mesh.has_roughness |= take_number(*from, roughness, textures, to.roughness, to.roughness_channel);
    mesh.has_metallic |= take_number(*from, metallic, textures, to.metallic, to.metallic_channel);
    mesh.materials.push_back(std::move(to));
  }
  if (mesh.materials.empty()) mesh.materials.emplace_back();
  note_bare_metal(mesh);
}

}  // namespace relume
