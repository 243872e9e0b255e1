// From materials and a band of the G-buffer to what the kernels read: a program for each pair of lobes, a field for each parameter.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "gbuffer/gbuffer.h"
#include "host/bound_material.h"

namespace relume {

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
  /// The layer that tells the objects of a material file apart; null where there is none.
  const ObjectIds* objects() const { return objects_ ? &*objects_ : nullptr; }
  /// "lambert + ggx (schlick, smith)" for each program.
  std::vector<std::string> descriptions() const;

  /// Fills the program plane and the parameters' planes and `frame`'s fields. An id without a material is Error{input} that lists the ids.
  void bind(GBuffer& gbuffer, const Camera& camera, Frame& frame) const;
  /// The same for a Lambert surface of albedo pi everywhere: what it reflects is the irradiance.
  void bind_irradiance(GBuffer& gbuffer, Frame& frame) const;

 private:
  void want(const std::string& role);
  void choose_program(const BoundMaterial& material);
  void gather_roles(const BoundMaterial& material);
  void finish_tables();
  std::vector<int> materials_of_pixels(const GBuffer& gbuffer) const;
  [[noreturn]] void refuse_unknown(const std::set<std::uint32_t>& ids) const;
  void fill_program_plane(GBuffer& gbuffer, const std::vector<int>& material, Frame& frame) const;
  void solve_cycles_surfaces(GBuffer& gbuffer, const Camera& camera) const;

  std::string place_;
  std::vector<BoundMaterial> materials_;
  std::map<std::uint32_t, int> by_id_;
  std::optional<ObjectIds> objects_;  ///< whose ids they are
  int fallback_ = -1;                 ///< position in materials_, or -1: an unknown id is an error
  std::vector<int> program_of_;       ///< of each material
  std::vector<Choice> programs_;
  std::vector<int> width_rules_;  ///< of each program
  std::vector<std::string> roles_, notes_;
  std::vector<float> tables_;
  int ambient_begin_ = 0, ambient_count_ = 0;
};

}  // namespace relume
