// The kernels for tests: one lane, in their own namespace, with a Surface of defaults and Cosines that are exact but for their last rounding.
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <ostream>
#include <string>
#include <string_view>

#include "host/cosines.h"

namespace relume::kernel {

#define RELUME_LANES 1
#include "kernels/shade.h"

#define RELUME_SET_1(value) value
#define RELUME_SET_3(value) grey(value)
#define RELUME_SET_DEFAULT(name, components, preset, ...) s.name = RELUME_SET_##components(preset);

/// A surface with every parameter at its default, seen from above, with the first of each term.
inline Surface default_surface() {
  Surface s{};
  s.n = s.base_n = s.v = real3_of(0.0f, 0.0f, 1.0f);
  s.n_v = 1.0f;
  RELUME_PARAMETERS(RELUME_SET_DEFAULT)
  return s;
}

#define RELUME_ASSIGN_1(member) member = static_cast<float>(value)
#define RELUME_ASSIGN_3(member) member = grey(static_cast<float>(value))
#define RELUME_SET_NAMED(parameter, components, ...) \
  if (name == #parameter) {                          \
    RELUME_ASSIGN_##components(s.parameter);         \
    return true;                                     \
  }

/// Sets a parameter by its name, all channels alike; false where there is none of that name. `roughness` sets alpha too, as the host does.
inline bool set_parameter(Surface& s, std::string_view name, double value) {
  if (name == "roughness") s.alpha = static_cast<float>(value * value);
  RELUME_PARAMETERS(RELUME_SET_NAMED)
  return false;
}

inline Cosines cosines_from(double n_l, double n_v, double l_v) {
  const PreciseCosines p = precise_cosines(n_l, n_v, l_v);
  Cosines c;
  c.n_l = static_cast<float>(p.n_l);
  c.n_v = static_cast<float>(p.n_v);
  c.l_v = static_cast<float>(p.l_v);
  c.sum2 = static_cast<float>(p.sum2);
  c.across2 = static_cast<float>(p.across2);
  c.along2 = static_cast<float>(p.along2);
  c.tan2_h = static_cast<float>(p.tan2_h);
  c.chord2 = static_cast<float>(p.chord2);
  c.r_l = static_cast<float>(p.r_l);
  return c;
}

/// A lobe or term as the lists have it.
struct Lobe {
  std::string_view kind, name, parameters, shadowings, fresnels, distributions, claims;
  int number;
};
inline void PrintTo(const Lobe& lobe, std::ostream* out) { *out << lobe.kind << " " << lobe.name; }  // for gtest's messages

#define RELUME_DIFFUSE_ROW(name, parameters, shadowings, fresnels, distributions, claims, source) \
  {"diffuse", #name, parameters, shadowings, fresnels, distributions, claims, DIFFUSE_##name},
#define RELUME_SPECULAR_ROW(name, parameters, shadowings, fresnels, distributions, claims, source) \
  {"specular", #name, parameters, shadowings, fresnels, distributions, claims, SPECULAR_##name},
inline constexpr Lobe lobes[] = {RELUME_DIFFUSE_LOBES(RELUME_DIFFUSE_ROW) RELUME_SPECULAR_LOBES(RELUME_SPECULAR_ROW)};

inline real3 reflect_lobe(const Lobe& lobe, const Cosines& c, const Surface& s) {
  const bool diffuse = lobe.kind == "diffuse";
  const Choice choice{diffuse ? lobe.number : 0, diffuse ? 0 : lobe.number, s.fresnel, s.shadowing, s.distribution};
  const Surface ready = looked_up(choice, s);
  return diffuse ? reflect_diffuse(lobe.number, c, ready) : reflect_specular(lobe.number, c, ready);
}

#define RELUME_NAMED_FRESNEL(term, ...) \
  if (name == #term) return FRESNEL_##term;
#define RELUME_NAMED_SHADOWING(term, ...) \
  if (name == #term) return SHADOWING_##term;
#define RELUME_NAMED_DISTRIBUTION(term, ...) \
  if (name == #term) return DISTRIBUTION_##term;
/// The number of a term of that name; -1 where there is none.
inline int fresnel_named(std::string_view name) { RELUME_FRESNELS(RELUME_NAMED_FRESNEL) return -1; }
inline int shadowing_named(std::string_view name) { RELUME_SHADOWINGS(RELUME_NAMED_SHADOWING) return -1; }
inline int distribution_named(std::string_view name) { RELUME_DISTRIBUTIONS(RELUME_NAMED_DISTRIBUTION) return -1; }

}  // namespace relume::kernel
