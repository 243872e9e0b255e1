// One material with every question answered: lobes and terms chosen, every parameter traced to a constant, a layer or a texture.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gbuffer/reading.h"
#include "host/conversions.h"
#include "host/frame.h"
#include "host/materials.h"

namespace relume {

/// Finds a layer by the name that a person gave it: gbuffer/reading.h's find_layer over a file, or columns of a table.
using LayerFinder = std::function<RoleLayer(const std::string& layer)>;

/// Where a kernel's field takes its values from.
struct FieldSource {
  std::vector<double> constant;  ///< 1 or 3 numbers, if it is one
  std::string role;              ///< else a role of the G-buffer
  std::optional<TextureValue> texture;
  std::string uv_role;        ///< of the texture's coordinates
  Convert convert = nullptr;  ///< roughness for alpha; null: as it is

  bool is_constant() const { return role.empty() && !texture; }
  /// A value as the field holds it.
  double converted(double value) const { return convert ? convert(value) : value; }
};

/// A material with every question answered: lobes by number, each field's source.
struct BoundMaterial {
  Choice choice{};
  int width_rule = WIDTH_alpha;
  Facing facing = Facing::as_stored;
  std::map<int, FieldSource> fields;  ///< FIELD_... of those that its lobes read
  bool solve_cycles = false;          ///< base colour, metallic and specular level are to be found from GlossCol and DiffCol
};

/// The table buffer while materials are bound.
struct LobeTables {
  std::vector<float> values;
  std::map<std::shared_ptr<const MerlTable>, std::size_t> merl;  ///< where each measured BRDF starts; null is the one that stands in
};

/// Answers them: from the material, else the file's layers, else the parameter's default. Layers that the material names are added to `reading.roles`
/// under their own names, tables that its lobes need to `tables`, sentences about what was assumed to `notes` (each once).
/// `place` begins messages: the file's name. Throws Error{input} naming the parameter, layer or lobe.
BoundMaterial bind_material(const Material& material, const std::string& place, const LayerFinder& find, Reading& reading, LobeTables& tables,
                            std::vector<std::string>& notes);

}  // namespace relume
