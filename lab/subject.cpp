// compared: which BRDF takes which parameter is told by the kernels' lists.
#include "lab/subject.h"

#include <algorithm>

#include "gbuffer/error.h"
#include "gbuffer/printable.h"
#include "host/brdf_name.h"
#include "host/lobes.h"

namespace relume {
namespace {

template <class Names>
bool contains(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Whether the lobe, with the Fresnel term that the material's settings tell, has a use for the parameter.
bool takes(const Lobe* lobe, const Material& material, const std::string& parameter) {
  if (!lobe) return false;
  if (parameter == "shadowing") return !lobe->shadowings.empty();
  if (parameter == "fresnel") return !lobe->fresnels.empty();
  if (parameter == "distribution") return !lobe->distributions.empty();
  const Term* fresnel = fresnel_of(material, *lobe);
  if (parameter == "albedo" && !material.parameters.contains("metallic")) fresnel = nullptr;  // metallic mixes it in, and is 0 where it is not given
  return contains(user_parameters(*lobe), parameter) || (fresnel && contains(user_parameters(*fresnel), parameter));
}

/// Leaves out what the BRDF has no use for.
void prune(Subject& subject) {
  Material material = material_named(subject.brdf);
  for (const std::string& assignment : subject.assignments()) set_parameter(material, assignment);
  const Lobe* diffuse = find_lobe(true, material.diffuse);
  const Lobe* specular = find_lobe(false, material.specular);
  std::erase_if(subject.settings,
                [&](const Setting& s) { return !takes(diffuse, material, s.parameter) && !takes(specular, material, s.parameter); });
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

Sweep sweep_of(const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == assignment.size())
    throw Error(ErrorKind::input, "--set " + printable(assignment) + ": must be PARAM=VALUE, PARAM=VALUE,VALUE, or PARAM=R,G,B;R,G,B");
  Sweep sweep{assignment.substr(0, equals), {}};
  const std::string values = assignment.substr(equals + 1);
  const Parameter* parameter = find_parameter(sweep.parameter);
  const bool commas_separate = values.find(';') == std::string::npos && !(parameter && parameter->components == 3);
  sweep.values = split(values, commas_separate ? ',' : ';');
  for (const std::string& value : sweep.values) {
    Material any;
    if (parameter && parameter->components == 3 && std::count(value.begin(), value.end(), ',') == 1)
      throw Error(ErrorKind::input,
                  "--set " + printable(assignment) + ": " + sweep.parameter + " is r,g,b or one number (; separates values of a sweep)");
    set_parameter(any, sweep.parameter + "=" + value);  // names and ranges, before anything is computed
  }
  return sweep;
}

/// A parameter given again has more values.
std::vector<Sweep> sweeps_of(const std::vector<std::string>& set) {
  std::vector<Sweep> sweeps;
  for (const std::string& assignment : set) {
    Sweep next = sweep_of(assignment);
    const auto same = std::find_if(sweeps.begin(), sweeps.end(), [&](const Sweep& s) { return s.parameter == next.parameter; });
    if (same == sweeps.end())
      sweeps.push_back(std::move(next));
    else
      same->values.insert(same->values.end(), next.values.begin(), next.values.end());
  }
  return sweeps;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// All combinations of the values, each once where some of them are of no use.
std::vector<Subject> subjects_of(const std::string& brdf, const std::vector<Sweep>& sweeps, std::size_t most) {
  std::vector<Subject> all{{brdf, {}}};
  for (const Sweep& sweep : sweeps) {
    std::vector<Subject> next;
    for (const Subject& subject : all)
      for (const std::string& value : sweep.values) {
        next.push_back(subject);
        next.back().settings.push_back({sweep.parameter, value});
      }
    all = std::move(next);
    constexpr std::size_t spare = 16;  // combinations may turn out to be alike
    if (all.size() > spare * most)
      throw Error(ErrorKind::input, "--set: " + std::to_string(all.size()) + " combinations (too many to be told apart)");
  }
  std::vector<Subject> own;
  for (Subject& subject : all) {
    prune(subject);
    const auto same = [&](const Subject& other) { return other.assignments() == subject.assignments(); };
    if (std::none_of(own.begin(), own.end(), same)) own.push_back(std::move(subject));
  }
  return own;
}

void check_taken(const Comparison& comparison, const std::vector<std::string>& brdfs) {
  for (const Sweep& sweep : comparison.sweeps)
    if (std::all_of(comparison.subjects.begin(), comparison.subjects.end(), [&](const Subject& s) { return s.value(sweep.parameter).empty(); }))
      throw Error(ErrorKind::input, "--set " + sweep.parameter + ": no parameter of " + joined(brdfs) + " (relume list brdfs has each one's)");
}

}  // namespace

std::vector<std::string> Subject::assignments() const {
  std::vector<std::string> all;
  for (const Setting& s : settings) all.push_back(s.parameter + "=" + s.value);
  return all;
}

std::string Subject::value(const std::string& parameter) const {
  for (const Setting& s : settings)
    if (s.parameter == parameter) return s.value;
  return {};
}

std::string Comparison::label(const Subject& subject) const {
  std::string text = subject.brdf;
  for (const Sweep& sweep : sweeps)
    if (const std::string value = subject.value(sweep.parameter); sweep.varies() && !value.empty()) text += ", " + sweep.parameter + " = " + value;
  return text;
}

std::string Comparison::constants() const {
  std::string text;
  for (const Sweep& sweep : sweeps)
    if (!sweep.varies()) text += (text.empty() ? "" : ", ") + sweep.parameter + " = " + sweep.values.front();
  return text;
}

Comparison compared(const std::vector<std::string>& brdfs, const std::vector<std::string>& set, std::size_t most) {
  Comparison comparison{{}, sweeps_of(set)};
  for (const std::string& brdf : brdfs) {
    const std::vector<Subject> own = subjects_of(brdf, comparison.sweeps, most);
    comparison.subjects.insert(comparison.subjects.end(), own.begin(), own.end());
  }
  if (comparison.subjects.empty()) throw Error(ErrorKind::input, "--brdf: names no BRDF (relume list brdfs)");
  check_taken(comparison, brdfs);
  if (comparison.subjects.size() > most)
    throw Error(ErrorKind::input,
                "--brdf, --set: " + std::to_string(comparison.subjects.size()) + " of them (at most " + std::to_string(most) + " can be told apart)");
  return comparison;
}

}  // namespace relume
