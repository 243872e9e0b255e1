// bind_material: lobes, terms, then each of their parameters.
#include "host/bound_material.h"

#include <algorithm>

#include "gbuffer/error.h"
#include "host/conversions.h"
#include "host/lobes.h"
#include "host/merl_numbers.h"
#include "host/rough_transmittance.h"

namespace relume {
namespace {

bool contains(const std::vector<std::string_view>& list, std::string_view name) { return std::find(list.begin(), list.end(), name) != list.end(); }

/// Builds one BoundMaterial from what a user said and what the file holds.
class Binder {
 public:
  Binder(const Material& material, const std::string& place, const LayerFinder& find, Reading& reading, LobeTables& tables,
         std::vector<std::string>& notes)
      : material_(material), place_(place), find_(find), reading_(reading), tables_(tables), notes_(notes) {}

  BoundMaterial bind() {
    choose_lobes();
    choose_terms();
    bound_.facing = material_.twosided ? (*material_.twosided ? Facing::two_sided : Facing::one_sided) : reading_.facing;
    for (const Lobe* lobe : {diffuse_, specular_})
      if (lobe)
        for (const std::string_view name : lobe->parameters) place(std::string(name));
    if (fresnel_)
      for (const std::string_view name : fresnel_->parameters) place(std::string(name));
    special_cases();
    note_unread();
    return bound_;
  }

 private:
  bool given(const std::string& parameter) const { return material_.parameters.contains(parameter); }
  bool in_file(const std::string& role) const { return reading_.roles.contains(role) || is_made(reading_, role); }
  void note(const std::string& text) {
    if (std::find(notes_.begin(), notes_.end(), text) == notes_.end()) notes_.push_back(text);
  }

  void choose_lobes() {
    if (material_.diffuse.empty()) material_.diffuse = default_diffuse();
    if (material_.specular.empty()) material_.specular = default_specular();
    diffuse_ = material_.diffuse == "none" ? nullptr : &lobe_named(true, material_.diffuse);
    specular_ = material_.specular == "none" ? nullptr : &lobe_named(false, material_.specular);
    bound_.choice.diffuse = diffuse_ ? diffuse_->number : int(DIFFUSE_none);
    bound_.choice.specular = specular_ ? specular_->number : int(SPECULAR_none);
  }

  /// The convention's; but glTF's diffuse light leaves room for glTF's own highlight, not for another that the user asks for, and a measured table
  /// holds the diffuse light too.
  std::string default_diffuse() const {
    if (material_.specular == "merl" || (material_.specular.empty() && given("table"))) return "none";
    const bool paired = material_.specular.empty() || material_.specular == reading_.default_specular;
    return reading_.default_diffuse == "gltf" && !paired ? "lambert" : reading_.default_diffuse;
  }

  /// The convention's; but who sets a highlight's width wants a highlight, also where the file tells of none, and who names a
  /// measured table wants it shown.
  std::string default_specular() const {
    if (given("table")) return "merl";
    const bool wanted = given("roughness") || given("alpha") || given("f0");
    return reading_.default_specular == "none" && wanted ? "ggx" : reading_.default_specular;
  }

  /// The term named, which must be one of the lobe's, else the lobe's first.
  const Term* term(const std::vector<Term>& terms, const std::vector<std::string_view>& allowed, const std::string& named, const char* kind) const {
    if (allowed.empty()) return nullptr;
    if (named.empty()) return &term_named(terms, allowed.front(), kind);
    const Term& chosen = term_named(terms, named, kind);
    if (contains(allowed, chosen.name)) return &chosen;
    std::string list;
    for (const std::string_view name : allowed) list += (list.empty() ? "" : ", ") + std::string(name);
    throw Error(ErrorKind::input, std::string(specular_->name) + " takes no " + kind + " \"" + named + "\" (has: " + list + ")");
  }

  void choose_terms() {
    fresnel_ = nullptr;
    if (!specular_) return;
    fresnel_ = fresnel_of(material_, *specular_);
    const Term* shadowing = term(shadowings(), specular_->shadowings, material_.shadowing, "shadowing term");
    const Term* distribution = term(distributions(), specular_->distributions, material_.distribution, "distribution");
    bound_.choice.fresnel = fresnel_ ? fresnel_->number : 0;
    bound_.choice.shadowing = shadowing ? shadowing->number : 0;
    bound_.choice.distribution = distribution ? distribution->number : 0;
    if (contains(specular_->parameters, "exponent"))
      bound_.width_rule = specular_->name.starts_with("phong") ? WIDTH_chord_exponent : WIDTH_exponent;
    else if (!contains(specular_->parameters, "alpha") && contains(specular_->parameters, "roughness"))
      bound_.width_rule = WIDTH_roughness;
  }

  FieldSource from_value(const ParameterValue& value) {
    FieldSource source;
    if (const auto* constant = std::get_if<std::vector<double>>(&value)) {
      source.constant = *constant;
    } else if (const auto* layer = std::get_if<LayerValue>(&value)) {
      source.role = layer_role(layer->layer);
    } else {
      source.texture = std::get<TextureValue>(value);
      source.uv_role = layer_role(source.texture->uv.empty() ? "uv" : source.texture->uv);
    }
    return source;
  }

  /// A layer by a role's name or its own; the latter becomes a role.
  std::string layer_role(const std::string& layer) {
    if (!in_file(layer)) reading_.roles[layer] = find_(layer);
    return layer;
  }

  std::optional<FieldSource> source_of(const std::string& name) {
    if (const auto value = material_.parameters.find(name); value != material_.parameters.end()) return from_value(value->second);
    if (in_file(name)) return FieldSource{{}, name, {}, {}, {}};
    return {};
  }

  /// What the user gives comes first, in whatever words; then what the file has.
  std::optional<FieldSource> found(const std::string& name) {
    if (given(name)) return source_of(name);
    for (const Conversion& c : conversions())
      if (c.to == name && given(std::string(c.from))) return made(c);
    if (in_file(name)) return source_of(name);
    for (const Conversion& c : conversions())
      if (c.to == name && in_file(std::string(c.from))) return made(c);
    return {};
  }

  FieldSource made(const Conversion& c) {
    FieldSource source = *source_of(std::string(c.from));
    source.convert = c.convert;
    const std::string what = std::string(c.to) + " from " + std::string(c.from) + " (" + std::string(c.formula) + ")";
    const bool everyday = c.to == "alpha" && c.from == "roughness";
    if (!everyday && std::find(reading_.made.begin(), reading_.made.end(), what) == reading_.made.end()) reading_.made.push_back(what);
    return source;
  }

  /// Finds where a kernel parameter's values come from.
  void place(const std::string& name) {
    const Parameter& parameter = parameter_named(name);
    if (parameter.from_host || bound_.fields.contains(parameter.field)) return;
    if (parameter.is_file) return place_table(parameter);
    const std::optional<FieldSource> source = name == "base_color" ? (given("albedo") ? source_of("albedo") : source_of("base_color")) : found(name);
    if (!source && name == "albedo")
      note("warning: no layer tells the albedo: " + std::to_string(parameter.fallback).substr(0, 4) +
           " is taken for it everywhere (--map albedo=LAYER, --set albedo=R,G,B or a material file tells it)");
    bound_.fields[parameter.field] = source.value_or(FieldSource{{parameter.fallback}, {}, {}, {}});
  }

  /// One table that several materials show is put down once.
  void place_table(const Parameter& parameter) {
    std::shared_ptr<const MerlTable> table;
    if (given(std::string(parameter.name)))
      table = std::get<TableValue>(material_.parameters.at(std::string(parameter.name))).table;
    else
      note("warning: merl: no table is given: a made-up plastic stands in (--set table=FILE names one)");
    const auto [placed, fresh] = tables_.merl.try_emplace(table, 0);
    if (fresh) {
      const std::vector<float> numbers = merl_numbers(table ? *table : stand_in_table());
      placed->second = (tables_.values.size() + merl_alignment - 1) / merl_alignment * merl_alignment;
      tables_.values.resize(placed->second);
      tables_.values.insert(tables_.values.end(), numbers.begin(), numbers.end());
    }
    bound_.fields[parameter.field] = {{double(placed->second)}, {}, {}, {}};
  }

  /// A parameter that was given but that no lobe of this material reads is worth a word: with "auto" lobes nobody could refuse it before.
  void note_unread() {
    std::vector<std::string_view> read;
    for (const Lobe* lobe : {diffuse_, specular_})
      if (lobe)
        for (const std::string_view name : user_parameters(*lobe)) read.push_back(name);
    if (fresnel_)
      for (const std::string_view name : user_parameters(*fresnel_)) read.push_back(name);
    for (const auto& [name, value] : material_.parameters)
      if (!contains(read, name)) note(name + " is given but neither " + material_.diffuse + " nor " + material_.specular + " reads it");
  }

  void special_cases() {
    if (diffuse_ && diffuse_->name == "plastic") make_plastic();
    const bool principled = (diffuse_ && diffuse_->name == "principled") || (specular_ && specular_->name == "principled");
    if (principled && !given("ior")) level_to_ior();
    if (specular_ && (specular_->name == "cycles_principled" || specular_->name == "cycles_glossy")) cycles_roughness();
    if (specular_ && specular_->name == "cycles_principled" && !given("albedo") && !in_file("base_color")) {
      if (!in_file("glossy_albedo") || !in_file("albedo"))
        throw Error(ErrorKind::input,
                    place_ +
                        ": cycles_principled needs a base colour (layer \"Base Color\", --set albedo=...) or the passes GlossCol and DiffCol "
                        "to find it from");
      bound_.solve_cycles = true;
      note("base colour, metallic and specular level are not stored: found from GlossCol and DiffCol (--map base_color=LAYER names one)");
    }
  }

  void cycles_roughness() {
    if (given("roughness") || in_file("roughness")) return;
    note("no roughness layer: 0.5 is assumed (--set roughness=VALUE or --map roughness=LAYER says otherwise)");
  }

  double constant_of(const char* lobe, const std::string& name) const {
    const auto found = bound_.fields.find(parameter_named(name).field);
    if (found == bound_.fields.end()) return parameter_named(name).fallback;
    if (!found->second.is_constant())
      throw Error(ErrorKind::input, std::string(lobe) + ": " + name + " must be a constant: a table is made for it (a layer or texture was given)");
    return found->second.converted(found->second.constant.front());
  }

  void make_plastic() {
    const double ior = constant_of("plastic", "ior");
    FieldSource table{{-1.0}, {}, {}, {}}, fdr{{smooth_internal_fdr(ior)}, {}, {}, {}};
    if (given("alpha") || given("roughness")) {
      const std::string specular = specular_ ? std::string(specular_->name) : "";
      const bool beckmann = specular == "beckmann" || specular == "cook_torrance";
      const RoughTransmittance transmittance = rough_transmittance(beckmann, constant_of("plastic", "alpha"), ior);
      table.constant = {double(tables_.values.size())};
      fdr.constant = {transmittance.internal_fdr};
      tables_.values.insert(tables_.values.end(), transmittance.external.begin(), transmittance.external.end());
    }
    bound_.fields[FIELD_transmittance] = table;
    bound_.fields[FIELD_fdr] = fdr;
  }

  /// Principled's ior from its specular level, which is the parameter that artists set.
  void level_to_ior() {
    std::optional<FieldSource> level = source_of("specular_level");
    if (!level) return;
    level->convert = ior_from_specular_level;
    bound_.fields[FIELD_ior] = *level;
  }

  Material material_;  ///< its "auto" lobes are named once choose_lobes() has run
  const std::string& place_;
  const LayerFinder& find_;
  Reading& reading_;
  LobeTables& tables_;
  std::vector<std::string>& notes_;
  BoundMaterial bound_;
  const Lobe *diffuse_ = nullptr, *specular_ = nullptr;
  const Term* fresnel_ = nullptr;
};

}  // namespace

BoundMaterial bind_material(const Material& material, const std::string& place, const LayerFinder& find, Reading& reading, LobeTables& tables,
                            std::vector<std::string>& notes) {
  return Binder(material, place, find, reading, tables, notes).bind();
}

}  // namespace relume
