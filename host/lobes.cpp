// The kernels' lists as C++ sees them: each X-macro list is expanded once more, into a vector.
#include "host/lobes.h"

#include <algorithm>
#include <sstream>

#include "gbuffer/error.h"
#include "host/json.h"
#include "host/surrounding_lights.h"

namespace relume {
namespace kernel {
#include "kernels/frame.h"
}  // namespace kernel

namespace {

std::vector<std::string_view> split(std::string_view words) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin < words.size();) {
    const std::size_t end = std::min(words.find(' ', begin), words.size());
    if (end > begin) parts.push_back(words.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

template <typename Items>
auto find_named(const Items& items, std::string_view name) -> decltype(items.data()) {
  const auto found = std::find_if(items.begin(), items.end(), [&](const auto& item) { return item.name == name; });
  return found == items.end() ? nullptr : &*found;
}

template <typename Items>
std::vector<std::string_view> collect_names(const Items& items) {
  std::vector<std::string_view> names;
  for (const auto& item : items) names.push_back(item.name);
  return names;
}

[[noreturn]] void no_such(std::string_view kind, std::string_view name, const std::vector<std::string_view>& has) {
  throw Error(ErrorKind::input, "no " + std::string(kind) + " " + in_quotes(name) + " (has: " + listed(has) + ")");
}

bool contains(const std::vector<std::string_view>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void add_once(std::vector<std::string_view>& names, std::string_view name) {
  if (!contains(names, name)) names.push_back(name);
}

std::vector<std::string_view> given_by_users(const std::vector<std::string_view>& names) {
  std::vector<std::string_view> given;
  for (const std::string_view name : names)
    if (const Parameter* parameter = find_parameter(name); parameter && !parameter->from_host) given.push_back(name);
  return given;
}

}  // namespace

// The marks in `meaning` are how parameters.h says who gives a value and what kind it is.
const std::vector<Parameter>& parameters() {
#define RELUME_ITEM(name, components, fallback, lowest, highest, meaning) \
  {#name,                                                                 \
   components,                                                            \
   fallback,                                                              \
   lowest,                                                                \
   highest,                                                               \
   meaning,                                                               \
   kernel::FIELD_##name,                                                  \
   std::string_view(meaning).starts_with("set by the host"),              \
   std::string_view(meaning).ends_with("(0 or 1)"),                       \
   std::string_view(meaning).ends_with("(a file)")},
  static const std::vector<Parameter> list = {RELUME_PARAMETERS(RELUME_ITEM)};
#undef RELUME_ITEM
  return list;
}

const std::vector<Lobe>& diffuse_lobes() {
#define RELUME_ITEM(name, parameters, shadowings, fresnels, distributions, claims, source) \
  {#name, true, split(parameters), split(shadowings), split(fresnels), split(distributions), split(claims), source, kernel::DIFFUSE_##name},
  static const std::vector<Lobe> list = {RELUME_DIFFUSE_LOBES(RELUME_ITEM)};
#undef RELUME_ITEM
  return list;
}

const std::vector<Lobe>& specular_lobes() {
#define RELUME_ITEM(name, parameters, shadowings, fresnels, distributions, claims, source) \
  {#name, false, split(parameters), split(shadowings), split(fresnels), split(distributions), split(claims), source, kernel::SPECULAR_##name},
  static const std::vector<Lobe> list = {RELUME_SPECULAR_LOBES(RELUME_ITEM)};
#undef RELUME_ITEM
  return list;
}

const std::vector<Term>& fresnels() {
#define RELUME_ITEM(name, parameters, source) {#name, split(parameters), source, kernel::FRESNEL_##name},
  static const std::vector<Term> list = {RELUME_FRESNELS(RELUME_ITEM)};
#undef RELUME_ITEM
  return list;
}

const std::vector<Term>& shadowings() {
#define RELUME_ITEM(name, source) {#name, {}, source, kernel::SHADOWING_##name},
  static const std::vector<Term> list = {RELUME_SHADOWINGS(RELUME_ITEM)};
#undef RELUME_ITEM
  return list;
}

const std::vector<Term>& distributions() {
#define RELUME_ITEM(name, source) {#name, {}, source, kernel::DISTRIBUTION_##name},
  static const std::vector<Term> list = {RELUME_DISTRIBUTIONS(RELUME_ITEM)};
#undef RELUME_ITEM
  return list;
}

const std::vector<Term>& light_types() {
#define RELUME_ITEM(name, keys, source) {#name, split(keys), source, kernel::LIGHT_##name},
  static const std::vector<Term> list = {RELUME_LIGHTS(RELUME_ITEM)};
#undef RELUME_ITEM
  return list;
}

const std::vector<Term>& surrounding_light_types() {
  static const std::vector<Term> list = [] {
#define RELUME_ITEM(name, keys, source) {#name, split(keys), source, 0},
    std::vector<Term> terms = {RELUME_SURROUNDING_LIGHTS(RELUME_ITEM)};
#undef RELUME_ITEM
    for (int number = kernel::LIGHT_COUNT; Term & term : terms) term.number = number++;
    return terms;
  }();
  return list;
}

std::vector<Term> all_light_types() {
  std::vector<Term> all = light_types();
  all.insert(all.end(), surrounding_light_types().begin(), surrounding_light_types().end());
  return all;
}

const Parameter* find_parameter(std::string_view name) { return find_named(parameters(), name); }
const Lobe* find_lobe(bool diffuse, std::string_view name) { return find_named(diffuse ? diffuse_lobes() : specular_lobes(), name); }
const Term* find_term(const std::vector<Term>& terms, std::string_view name) { return find_named(terms, name); }

const Parameter& parameter_named(std::string_view name) {
  if (const Parameter* parameter = find_parameter(name)) return *parameter;
  no_such("parameter", name, parameter_names());
}

const Lobe& lobe_named(bool diffuse, std::string_view name) {
  if (const Lobe* lobe = find_lobe(diffuse, name)) return *lobe;
  std::vector<std::string_view> names = names_of(diffuse ? diffuse_lobes() : specular_lobes());
  names.insert(names.begin(), "none");
  no_such(diffuse ? "diffuse lobe" : "specular lobe", name, names);
}

const Term& term_named(const std::vector<Term>& terms, std::string_view name, std::string_view kind) {
  if (const Term* term = find_term(terms, name)) return *term;
  no_such(kind, name, names_of(terms));
}

std::vector<std::string_view> names_of(const std::vector<Lobe>& lobes) { return collect_names(lobes); }
std::vector<std::string_view> names_of(const std::vector<Term>& terms) { return collect_names(terms); }

std::vector<std::string_view> parameter_names() { return given_by_users(collect_names(parameters())); }

std::vector<std::string_view> user_parameters(const Lobe& lobe) {
  std::vector<std::string_view> names = given_by_users(lobe.parameters);
  if (contains(names, "alpha")) add_once(names, "roughness");
  if (contains(names, "base_color")) add_once(names, "albedo");
  return names;
}

std::vector<std::string_view> user_parameters(const Term& fresnel) { return given_by_users(fresnel.parameters); }

}  // namespace relume
