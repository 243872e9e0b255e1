// Binding: the materials of a frame, gathered into programs and roles.
#include "host/binding.h"

#include <algorithm>

#include "gbuffer/error.h"
#include "host/ambient_nodes.h"
#include "host/ggx_albedo.h"
#include "host/lobes.h"
#include "kernels/cycles_tables.h"

namespace relume {
namespace {

/// What the command line says wins over the material file; a parameter's alternative spelling is replaced with it.
Material merged(Material base, const Material& over) {
  for (const auto member : {&Material::diffuse, &Material::specular, &Material::shadowing, &Material::fresnel, &Material::distribution})
    if (!(over.*member).empty()) base.*member = over.*member;
  if (over.twosided) base.twosided = over.twosided;
  for (const auto& [name, value] : over.parameters) {
    if (name == "alpha") base.parameters.erase("roughness");
    if (name == "roughness") base.parameters.erase("alpha");
    base.parameters[name] = value;
  }
  return base;
}

bool same(const Choice& a, const Choice& b) {
  return a.diffuse == b.diffuse && a.specular == b.specular && a.fresnel == b.fresnel && a.shadowing == b.shadowing &&
         a.distribution == b.distribution;
}

}  // namespace

Binding::Binding(const Material& command_line, const std::optional<MaterialFile>& file, const std::string& place, const LayerFinder& find,
                 Reading& reading)
    : place_(place) {
  LobeTables tables;
  tables.values.resize(RELUME_CYCLES_TABLES_LENGTH);  // first, where kernels/cycles_tables.h has them; filled if a lobe reads them
  const auto add = [&](const Material& material) {
    materials_.push_back(bind_material(merged(material, command_line), place_, find, reading, tables, notes_));
    return int(materials_.size()) - 1;
  };
  if (!file) {
    fallback_ = add({});
  } else {
    for (const auto& [id, material] : file->by_id) by_id_[id] = add(material);
    if (file->fallback) fallback_ = add(*file->fallback);
    objects_ = file->objects;
    if (objects_) {
      for (const std::string& role : objects_->roles()) want(role);
      notes_.insert(notes_.end(), objects_->notes().begin(), objects_->notes().end());
    }
  }
  for (const BoundMaterial& material : materials_) {
    choose_program(material);
    gather_roles(material);
  }
  tables_ = std::move(tables.values);
  finish_tables();
}

void Binding::want(const std::string& role) {
  if (!role.empty() && std::find(roles_.begin(), roles_.end(), role) == roles_.end()) roles_.push_back(role);
}

void Binding::choose_program(const BoundMaterial& material) {
  const auto found = std::find_if(programs_.begin(), programs_.end(), [&](const Choice& program) { return same(program, material.choice); });
  program_of_.push_back(int(found - programs_.begin()));
  if (found != programs_.end()) return;
  programs_.push_back(material.choice);
  width_rules_.push_back(material.width_rule);
}

void Binding::gather_roles(const BoundMaterial& material) {
  for (const auto& [field, source] : material.fields)
    for (const std::string& role : {source.role, source.uv_role}) want(role);
  if (!material.solve_cycles) return;
  want("glossy_albedo");
  want("albedo");
}

void Binding::finish_tables() {
  const auto reads_cycles = [](const Choice& p) { return p.specular == SPECULAR_cycles_principled || p.specular == SPECULAR_cycles_glossy; };
  if (std::any_of(programs_.begin(), programs_.end(), reads_cycles)) {
    const std::vector<float> cycles = cycles_tables();
    std::copy(cycles.begin(), cycles.end(), tables_.begin());
  }
  const std::vector<float> nodes = ambient_nodes();
  ambient_begin_ = int(tables_.size());
  ambient_count_ = int(nodes.size() / 4);
  tables_.insert(tables_.end(), nodes.begin(), nodes.end());
}

int Binding::spare_planes() const {
  int planes = 2;  // program, constants
  for (const Parameter& parameter : parameters()) planes += parameter.components;
  return planes + 1;  // facing
}

std::vector<std::string> Binding::descriptions() const {
  const auto lobe_name = [](const std::vector<Lobe>& lobes, int number) {
    return number == 0 ? std::string("none") : std::string(lobes[std::size_t(number - 1)].name);
  };
  std::vector<std::string> all;
  for (const Choice& program : programs_) {
    std::string text = lobe_name(diffuse_lobes(), program.diffuse) + " + " + lobe_name(specular_lobes(), program.specular), terms;
    const auto add = [&](const std::vector<Term>& list, const std::vector<std::string_view>& allowed, int number) {
      if (!allowed.empty()) terms += (terms.empty() ? "" : ", ") + std::string(list[std::size_t(number)].name);
    };
    if (program.specular != SPECULAR_none) {
      const Lobe& lobe = specular_lobes()[std::size_t(program.specular - 1)];
      add(fresnels(), lobe.fresnels, program.fresnel);
      add(shadowings(), lobe.shadowings, program.shadowing);
      add(distributions(), lobe.distributions, program.distribution);
    }
    all.push_back(terms.empty() ? text : text + " (" + terms + ")");
  }
  return all;
}

}  // namespace relume
