// From materials and a band of the G-buffer to what the kernels read: a program for each pair of lobes, a field for each parameter.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "gbuffer/gbuffer.h"
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
  std::string uv_role;           ///< of the texture's coordinates
  enum class Transform { none, square, ior_from_level } transform = Transform::none;  ///< roughness for alpha; specular level for ior

  bool is_constant() const { return role.empty() && !texture; }
};

double transformed(FieldSource::Transform transform, double value);

/// A material with every question answered: lobes by number, each field's source.
struct BoundMaterial {
  Choice choice{};
  int width_rule = WIDTH_alpha;
  Facing facing = Facing::as_stored;
  std::map<int, FieldSource> fields;  ///< FIELD_... of those that its lobes read
  bool solve_cycles = false;          ///< base colour, metallic and specular level are to be found from GlossCol and DiffCol
};

/// The materials of a frame, made once; knows which roles of the file it needs.
class Binding {
 public:
  /// `command_line`: --diffuse, --specular, --set: wins over the file. Layers that materials name are added to `reading.roles` under their own names.
  /// Throws Error{input} naming the parameter, layer or lobe.
  /// `place` begins messages: the file's name.
  Binding(const Material& command_line, const std::optional<MaterialFile>& file, const std::string& place, const LayerFinder& find, Reading& reading);

  /// Roles to read beside position, normal and coverage.
  const std::vector<std::string>& roles() const { return roles_; }
  /// Planes that bind() adds to a band at most.
  int spare_planes() const;
  /// Tables of the lobes (plastic's transmittance, Cycles' albedo, ambient's quadrature), the same for all bands.
  const std::vector<float>& tables() const { return tables_; }
  int ambient_nodes_begin() const { return ambient_begin_; }
  int ambient_node_count() const { return ambient_count_; }
  const std::vector<Choice>& programs() const { return programs_; }
  int width_rule(int program) const { return width_rules_[std::size_t(program)]; }
  const std::vector<std::string>& notes() const { return notes_; }
  /// "lambert + ggx (schlick, smith)" for each program.
  std::vector<std::string> descriptions() const;

  /// Fills the program plane and the parameters' planes and `frame`'s fields. An id without a material is Error{input} that lists the ids.
  void bind(GBuffer& gbuffer, const Camera& camera, Frame& frame) const;
  /// The same for a Lambert surface of albedo pi everywhere: what it reflects is the irradiance.
  void bind_irradiance(GBuffer& gbuffer, Frame& frame) const;

 private:
  std::vector<int> materials_of_pixels(const GBuffer& gbuffer) const;
  void fill_program_plane(GBuffer& gbuffer, const std::vector<int>& material, Frame& frame) const;
  void solve_cycles_surfaces(GBuffer& gbuffer, const Camera& camera) const;

  std::string place_;
  std::vector<BoundMaterial> materials_;
  std::map<std::uint32_t, int> by_id_;
  int fallback_ = -1;            ///< position in materials_, or -1: an unknown id is an error
  std::vector<int> program_of_;  ///< of each material
  std::vector<Choice> programs_;
  std::vector<int> width_rules_;  ///< of each program
  std::vector<std::string> roles_, notes_;
  std::vector<float> tables_;
  int ambient_begin_ = 0, ambient_count_ = 0;
};

}  // namespace relume
