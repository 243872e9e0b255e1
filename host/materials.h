// Materials as a material file or the command line states them (FORMATS: "The material file"): lobes by name, parameters as constants, layers or
// textures.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "gbuffer/object_ids.h"
#include "host/lobes.h"
#include "host/merl.h"

namespace relume {

struct LayerValue {
  std::string layer;  ///< a layer's name or a role's
};

struct TextureValue {
  std::filesystem::path file;  ///< absolute or relative to the working directory
  std::string uv;              ///< the layer with texture coordinates; default "uv"
  bool bilinear = true;        ///< else nearest
  bool v_down = false;         ///< v counts from the top row
};

/// A measured BRDF, of `merl`'s parameter `table`.
struct TableValue {
  std::shared_ptr<const MerlTable> table;
};

/// Numbers (as many as the parameter has components), a layer, a texture, or, of a parameter that is a file, what it holds.
using ParameterValue = std::variant<std::vector<double>, LayerValue, TextureValue, TableValue>;

struct Material {
  std::string diffuse, specular;                 ///< lobe names, "none", or empty: auto
  std::string shadowing, fresnel, distribution;  ///< empty: the lobe's default
  std::optional<bool> twosided;
  std::map<std::string, ParameterValue> parameters;
};

struct MaterialFile {
  std::string ids;  ///< the layer with the ids or the Cryptomatte; empty: the file's own
  std::map<std::uint32_t, Material> by_id;
  std::map<std::string, Material> by_name;  ///< objects of a Cryptomatte, until find_objects() puts them to ids
  std::optional<ObjectIds> objects;         ///< whose ids they are, once find_objects() has looked
  std::optional<Material> fallback;         ///< "default"
};

/// Strict, like read_rig. Lobe and parameter names are checked against the lists (host/lobes.h). "-" is standard input.
MaterialFile read_materials(const std::filesystem::path& file);

/// "alpha=0.2", "albedo=0.5,0.4,0.3", "fresnel=none", "distribution=ggx", "twosided=true" into `material`. Error{input} lists what is allowed.
/// Names and ranges are checked here; whether the parameters go together is left to check(), as the assignments may come in any order.
void set_parameter(Material& material, const std::string& assignment);

/// Error{input}, beginning with `place`, where a lobe, term or parameter is unknown, out of range, or of no use to the material's lobes.
/// Where a lobe is left to "auto", any known parameter may be there.
void check(const Material& material, const std::string& place);

/// The Fresnel term of one of the material's lobes (null where the lobe takes none): the one that it names, else the parameters tell:
/// `eta` or `k` conductor, else `ior` dielectric, else the lobe's first.
const Term* fresnel_of(const Material& material, const Lobe& lobe);

}  // namespace relume
