// The kernels' lists as C++ sees them: lobes, their terms, their parameters, and the lights. Made from kernels/*/list.h and kernels/parameters.h.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace relume {

/// A parameter that a lobe may have.
struct Parameter {
  std::string_view name;
  int components;                    ///< 1 or 3
  double fallback, lowest, highest;  ///< default and range
  std::string_view meaning;
  int field;       ///< kernels/frame.h's FIELD_<name>
  bool from_host;  ///< worked out by the host: users cannot give it
  bool is_switch;  ///< 0 or 1, also written false or true
  bool is_file;    ///< users name a file; the field holds where the host has put what it says
};

/// One half of a BRDF as users choose it.
struct Lobe {
  std::string_view name;
  bool diffuse;                                                                           ///< else specular
  std::vector<std::string_view> parameters, shadowings, fresnels, distributions, claims;  ///< the default first
  std::string_view source;
  int number;  ///< kernels/choice.h's DIFFUSE_<name> or SPECULAR_<name>; 0 is "none", which is in no list
};

/// A Fresnel term, a shadowing term, a distribution of normals, or a light with the keys that it has in a rig file.
struct Term {
  std::string_view name;
  std::vector<std::string_view> parameters;
  std::string_view source;
  int number;  ///< kernels/choice.h's FRESNEL_<name>, SHADOWING_<name>, ...
};

const std::vector<Parameter>& parameters();
const std::vector<Lobe>& diffuse_lobes();
const std::vector<Lobe>& specular_lobes();
const std::vector<Term>& fresnels();
const std::vector<Term>& shadowings();
const std::vector<Term>& distributions();
const std::vector<Term>& light_types();
/// Those of host/surrounding_lights.h, which have no kernel of their own; numbered after the others.
const std::vector<Term>& surrounding_light_types();
/// Both lists, by number.
std::vector<Term> all_light_types();

/// Null where there is none of this name.
const Parameter* find_parameter(std::string_view name);
/// Among diffuse or specular lobes; null for "none" too.
const Lobe* find_lobe(bool diffuse, std::string_view name);
const Term* find_term(const std::vector<Term>& terms, std::string_view name);

/// The same, or Error{input}: `no specular lobe "gxx" (has: none, phong, ...)`, `no parameter "rough" (has: ...)`, `no fresnel term "x" (has: ...)`.
/// `kind` names a term for people: "fresnel term", "light type".
const Parameter& parameter_named(std::string_view name);
const Lobe& lobe_named(bool diffuse, std::string_view name);
const Term& term_named(const std::vector<Term>& terms, std::string_view name, std::string_view kind);

/// Names in the list's order; for parameters those that users may give.
std::vector<std::string_view> names_of(const std::vector<Lobe>& lobes);
std::vector<std::string_view> names_of(const std::vector<Term>& terms);
std::vector<std::string_view> parameter_names();

/// What users may give to a lobe, without its Fresnel term's: the kernel's own, and `roughness` beside `alpha` (its square root), Cycles'
/// `albedo` beside `base_color`; nothing that the host works out.
std::vector<std::string_view> user_parameters(const Lobe& lobe);
/// What users may give to a Fresnel term: its own, and `albedo` beside `metallic`, which mixes the two.
std::vector<std::string_view> user_parameters(const Term& fresnel);

}  // namespace relume
