// examined: the grid of settings, from the lists of parameters and terms.
#include "lab/examined.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "gbuffer/error.h"
#include "host/materials.h"

namespace relume {
namespace {

std::string name_in(const std::string& assignment) { return assignment.substr(0, assignment.find('=')); }

bool contains(const std::vector<std::string_view>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string assigned(std::string_view name, double value) {
  char text[80];
  std::snprintf(text, sizeof text, "%.*s=%.9g", int(name.size()), name.data(), value);
  return text;
}

bool is_reflectance(const Parameter& p) { return p.components == 3 && p.lowest == 0 && p.highest == 1; }

/// Whether no reflectance is less than 1.
bool is_white(const Setting& setting) {
  return std::none_of(setting.begin(), setting.end(), [&](const std::string& assignment) {
    const Parameter* p = find_parameter(name_in(assignment));
    return p && is_reflectance(*p) && value_in(setting, name_in(assignment)) != "1";
  });
}

/// The words of a list's entry, or one empty word where it offers no choice.
std::vector<std::string_view> choices(const std::vector<std::string_view>& words) {
  return words.empty() ? std::vector<std::string_view>{""} : words;
}

std::vector<Setting> terms_of_lobe(const Lobe& lobe) {
  std::vector<Setting> all;
  for (const std::string_view fresnel : choices(lobe.fresnels))
    for (const std::string_view shadowing : choices(lobe.shadowings))
      for (const std::string_view distribution : choices(lobe.distributions)) {
        all.emplace_back();
        if (!fresnel.empty()) all.back().push_back("fresnel=" + std::string(fresnel));
        if (!shadowing.empty()) all.back().push_back("shadowing=" + std::string(shadowing));
        if (!distribution.empty()) all.back().push_back("distribution=" + std::string(distribution));
      }
  return all;
}

/// What the lobe reads with this choice of terms. `roughness` is not said beside `alpha`, nor a specular level beside the ior that it stands for.
std::vector<const Parameter*> parameters_of(const Lobe& lobe, const Setting& terms) {
  std::vector<std::string_view> names = lobe.parameters;
  if (const std::string fresnel = value_in(terms, "fresnel"); !fresnel.empty())
    for (const std::string_view name : term_named(fresnels(), fresnel, "fresnel term").parameters) names.push_back(name);
  std::vector<const Parameter*> all;
  for (const std::string_view name : names) {
    if (name == "roughness" && contains(names, "alpha")) continue;
    if (name == "specular_level" && lobe.name == "principled") continue;
    if (const Parameter& p = parameter_named(name); !p.from_host && !p.is_file) all.push_back(&p);
  }
  return all;
}

/// Reflectances at 1; but what is mirrored cannot be diffused, so a diffuse lobe keeps its f0. Cycles' base colour is given as albedo.
Setting white(const std::vector<const Parameter*>& parameters, bool diffuse) {
  Setting all;
  for (const Parameter* p : parameters)
    if (is_reflectance(*p) && !(diffuse && (p->name == "f0" || p->name == "f90")))
      all.push_back(assigned(p->name == "base_color" ? "albedo" : p->name, 1));
  return all;
}

/// Numbers one at a time, at their ends and between; then every corner of all ranges.
std::vector<Setting> numbers_tried(const std::vector<const Parameter*>& numbers) {
  std::vector<Setting> all{{}};
  Setting highest;
  for (const Parameter* p : numbers) highest.push_back(assigned(p->name, p->highest));
  for (const Setting& start : {Setting{}, highest})
    for (const Parameter* p : numbers)
      for (const double share : {0.0, 1e-4, 0.02, 0.1, 0.25, 0.5, 1.0})
        if (!p->is_switch || share == 0 || share == 1)
          all.push_back(with_others(start, {assigned(p->name, p->lowest + share * (p->highest - p->lowest))}));
  for (unsigned corner = 0; corner < 1u << numbers.size(); ++corner) {
    Setting setting;
    for (std::size_t i = 0; i < numbers.size(); ++i)
      setting.push_back(assigned(numbers[i]->name, corner >> i & 1 ? numbers[i]->highest : numbers[i]->lowest));
    all.push_back(setting);
  }
  return all;
}

/// Error{input} where what the user has fixed does not go with the lobe or these terms.
void check_fixed(const Lobe& lobe, const Setting& terms, const Setting& fixed) {
  Material material;
  material.diffuse = lobe.diffuse ? std::string(lobe.name) : "none";
  material.specular = lobe.diffuse ? "none" : std::string(lobe.name);
  for (const std::string& assignment : with_others(terms, fixed)) set_parameter(material, assignment);
  check(material, std::string(lobe.name));
}

bool is_fixed(const Setting& fixed, const Parameter& p) {
  return !value_in(fixed, std::string(p.name)).empty() || (p.name == "alpha" && !value_in(fixed, "roughness").empty());
}

/// With the terms of one choice.
std::vector<Setting> grid_with(const Lobe& lobe, const Setting& terms, const Setting& fixed) {
  const std::vector<const Parameter*> parameters = parameters_of(lobe, terms);
  std::vector<const Parameter*> numbers;
  for (const Parameter* p : parameters)
    if (!is_reflectance(*p) && !is_fixed(fixed, *p)) numbers.push_back(p);
  const Setting base = with_others(white(parameters, lobe.diffuse), terms);
  std::vector<Setting> grid;
  for (const Setting& tried : numbers_tried(numbers)) grid.push_back(with_others(with_others(base, tried), fixed));
  return grid;
}

/// Whether the choice of terms is what the user has fixed.
bool agrees(const Setting& terms, const Setting& fixed) {
  return std::all_of(terms.begin(), terms.end(), [&](const std::string& term) {
    const std::string wanted = value_in(fixed, name_in(term));
    return wanted.empty() || wanted == value_in(terms, name_in(term));
  });
}

std::vector<Setting> grid_of(const Lobe& lobe, const Setting& fixed) {
  std::vector<Setting> grid;
  std::exception_ptr refusal;
  for (const Setting& terms : terms_of_lobe(lobe)) try {
      if (!agrees(terms, fixed)) continue;
      check_fixed(lobe, terms, fixed);
      const std::vector<Setting> more = grid_with(lobe, terms, fixed);
      grid.insert(grid.end(), more.begin(), more.end());
    } catch (const Error&) {
      refusal = std::current_exception();
    }
  if (grid.empty() && !refusal) check_fixed(lobe, {}, fixed);  // a term that the lobe does not have
  if (grid.empty()) std::rethrow_exception(refusal);
  std::sort(grid.begin(), grid.end());
  grid.erase(std::unique(grid.begin(), grid.end()), grid.end());
  return grid;
}

}  // namespace

Setting with_others(const Setting& base, const Setting& others) {
  Setting all = base;
  for (const std::string& other : others) {
    const std::string name = name_in(other), twin = name == "alpha" ? "roughness" : name == "roughness" ? "alpha" : name;
    std::erase_if(all, [&](const std::string& a) { return name_in(a) == name || name_in(a) == twin; });
    all.push_back(other);
  }
  return all;
}

std::string value_in(const Setting& setting, const std::string& name) {
  for (const std::string& assignment : setting)
    if (name_in(assignment) == name) return assignment.substr(name.size() + 1);
  return {};
}

std::string text_of(const Setting& setting) {
  std::string text;
  for (const std::string& assignment : setting) {
    const Parameter* p = find_parameter(name_in(assignment));
    if (p && is_reflectance(*p) && value_in(setting, name_in(assignment)) == "1") continue;
    text += (text.empty() ? "" : " ") + assignment;
  }
  return text.empty() ? "defaults" : text;
}

Examined examined(const Lobe& lobe, const Setting& fixed, std::shared_ptr<Device> device) {
  const std::string name(lobe.name);
  Examined e{name, lobe.diffuse, {}, {}, grid_of(lobe, fixed), {}, {}, {}};
  e.parameters.assign(lobe.parameters.begin(), lobe.parameters.end());
  for (const std::string_view claim : lobe.claims)
    if (is_white(fixed) || claim == "positive" || claim == "reciprocal" || claim == "conserving") e.claims.emplace_back(claim);
  // Some lobes' tables take 20 ms to make, and each law asks again.
  const auto made = std::make_shared<std::map<Setting, std::shared_ptr<Brdf>>>();
  e.with = [=](const Setting& set) -> ReflectanceOf {
    std::shared_ptr<Brdf>& brdf = (*made)[set];
    if (!brdf) brdf = std::make_shared<Brdf>(lobe.diffuse ? name + "+none" : "none+" + name, set, device);
    return [brdf = brdf](std::span<const DirectionPair> pairs) { return brdf->reflectance(pairs); };
  };
  e.terms = [=](const std::string& distribution, const Setting& set) { return terms_of(distribution, set, device); };
  return e;
}

}  // namespace relume
