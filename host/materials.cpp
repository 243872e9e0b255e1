// Material files and --set: which lobes, which terms, which values, each checked against the kernels' lists.
#include "host/materials.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "gbuffer/error.h"
#include "host/json.h"

namespace relume {
namespace {

using Names = std::vector<std::string_view>;

/// What is wrong with the value of a key.
struct Problem {
  std::string key, what;
};

bool contains(const Names& names, std::string_view name) { return std::find(names.begin(), names.end(), name) != names.end(); }

void add(Names& names, const Names& more) {
  for (const std::string_view name : more)
    if (!contains(names, name)) names.push_back(name);
}

/// The lobes that a half of the BRDF may come to: the named one, none, or, left to "auto", any.
std::vector<const Lobe*> candidates(const Material& material, bool diffuse) {
  const std::string& name = diffuse ? material.diffuse : material.specular;
  const Lobe* named = find_lobe(diffuse, name);
  if (named) return {named};
  std::vector<const Lobe*> all;
  if (name.empty())
    for (const Lobe& lobe : diffuse ? diffuse_lobes() : specular_lobes()) all.push_back(&lobe);
  return all;
}

std::vector<const Lobe*> candidates(const Material& material) {
  std::vector<const Lobe*> lobes = candidates(material, true);
  const std::vector<const Lobe*> specular = candidates(material, false);
  lobes.insert(lobes.end(), specular.begin(), specular.end());
  return lobes;
}

/// "lambert and ggx", for people.
std::string lobes_of(const Material& material) {
  const auto shown_name = [](const std::string& name) { return name.empty() ? std::string("auto") : name; };
  return "diffuse " + shown_name(material.diffuse) + " and specular " + shown_name(material.specular);
}

std::string range_of(const Parameter& parameter) { return in_digits(parameter.lowest) + ".." + in_digits(parameter.highest); }

std::optional<std::string> problem_of_value(const Parameter& parameter, const ParameterValue& value) {
  if (parameter.is_file != std::holds_alternative<TableValue>(value)) return parameter.is_file ? "must name a file" : "is no file";
  const auto* numbers = std::get_if<std::vector<double>>(&value);
  if (!numbers) return {};
  if (numbers->size() != static_cast<std::size_t>(parameter.components))
    return "must be " + std::to_string(parameter.components) + " number" + (parameter.components > 1 ? "s" : "");
  for (const double number : *numbers) {
    if (!(number >= parameter.lowest && number <= parameter.highest)) return in_digits(number) + " is out of range (" + range_of(parameter) + ")";
    if (parameter.is_switch && number != 0 && number != 1) return in_digits(number) + " is neither 0 nor 1 (false nor true)";
  }
  return {};
}

std::optional<Problem> problem_of_lobe(bool diffuse, const std::string& name) {
  if (name.empty() || name == "none" || find_lobe(diffuse, name)) return {};
  Names names = {"auto", "none"};
  add(names, names_of(diffuse ? diffuse_lobes() : specular_lobes()));
  return Problem{diffuse ? "diffuse" : "specular", "no lobe " + in_quotes(name) + " (has: " + listed(names) + ")"};
}

/// A term that is named must be one that some lobe takes.
std::optional<Problem> problem_of_term(const Material& material, const std::string& key, const std::string& name, Names Lobe::*taken) {
  if (name.empty()) return {};
  Names allowed;
  for (const Lobe* lobe : candidates(material)) add(allowed, lobe->*taken);
  if (contains(allowed, name)) return {};
  const std::string has = allowed.empty() ? "they take none" : "has: " + listed(allowed);
  return Problem{key, in_quotes(name) + " is not for " + lobes_of(material) + " (" + has + ")"};
}

/// What users may give to the lobes; with the Fresnel term's, where the lobe is known, else with every Fresnel term's.
Names parameters_of(const Material& material) {
  Names names;
  for (const bool diffuse : {true, false}) {
    const std::vector<const Lobe*> lobes = candidates(material, diffuse);
    for (const Lobe* lobe : lobes) {
      add(names, user_parameters(*lobe));
      const Term* fresnel = fresnel_of(material, *lobe);
      if (fresnel && lobes.size() == 1) add(names, user_parameters(*fresnel));
      if (lobes.size() > 1)
        for (const std::string_view term : lobe->fresnels) add(names, user_parameters(term_named(fresnels(), term, "fresnel term")));
    }
  }
  return names;
}

/// Some lobe takes `alpha` or `roughness` in its place, and none takes `roughness` for itself.
bool alpha_given_twice(const Material& material) {
  if (!material.parameters.contains("alpha") || !material.parameters.contains("roughness")) return false;
  for (const bool diffuse : {true, false}) {
    const Lobe* lobe = find_lobe(diffuse, diffuse ? material.diffuse : material.specular);
    if (lobe && contains(lobe->parameters, "roughness") && !contains(lobe->parameters, "alpha")) return false;
  }
  return true;
}

std::optional<Problem> problem_of_parameters(const Material& material) {
  const Names allowed = parameters_of(material);
  for (const auto& [name, value] : material.parameters) {
    if (!contains(parameter_names(), name)) return Problem{name, "no such parameter (has: " + listed(allowed) + ")"};
    if (!contains(allowed, name)) {
      std::string with;
      for (const bool diffuse : {true, false})
        if (const std::vector<const Lobe*> lobes = candidates(material, diffuse); lobes.size() == 1)
          if (const Term* fresnel = fresnel_of(material, *lobes[0])) with = " with fresnel " + std::string(fresnel->name);
      const std::string has = allowed.empty() ? "they take none" : "has: " + listed(allowed);
      return Problem{name, "not a parameter of " + lobes_of(material) + with + " (" + has + ")"};
    }
    if (const auto problem = problem_of_value(parameter_named(name), value)) return Problem{name, *problem};
  }
  if (alpha_given_twice(material)) return Problem{"alpha", "stands instead of \"roughness\" (alpha is its square; give one of them)"};
  return {};
}

std::optional<Problem> problem_of(const Material& material) {
  if (auto problem = problem_of_lobe(true, material.diffuse)) return problem;
  if (auto problem = problem_of_lobe(false, material.specular)) return problem;
  if (auto problem = problem_of_term(material, "shadowing", material.shadowing, &Lobe::shadowings)) return problem;
  if (auto problem = problem_of_term(material, "fresnel", material.fresnel, &Lobe::fresnels)) return problem;
  if (auto problem = problem_of_term(material, "distribution", material.distribution, &Lobe::distributions)) return problem;
  return problem_of_parameters(material);
}

TextureValue read_texture(const ObjectReader& reader, const std::filesystem::path& folder) {
  reader.allow({"texture", "uv", "filter", "v"});
  TextureValue texture;
  reader.need("texture");
  const std::string name = *reader.string("texture");
  if (name.empty()) reader.fail("texture", "must name a file");
  texture.file = folder / name;
  texture.uv = reader.string("uv").value_or("uv");
  texture.bilinear = reader.choice("filter", {"bilinear", "nearest"}).value_or(0) == 0;
  texture.v_down = reader.choice("v", {"up", "down"}).value_or(0) == 1;
  return texture;
}

ParameterValue read_value(const ObjectReader& reader, const std::string& key, const Json& value, const std::string& name,
                          const std::filesystem::path& folder) {
  const Parameter& parameter = *find_parameter(key);
  if (parameter.is_file) {
    const std::string file = reader.string(key).value_or("");
    if (file.empty()) reader.fail(key, "must name a file");
    return TableValue{shared_merl(folder / file)};
  }
  if (value.type == Json::Type::object) return read_texture(ObjectReader(value, name, reader.place() + ": " + key), folder);
  if (value.type == Json::Type::boolean && parameter.is_switch) return std::vector<double>{value.boolean ? 1.0 : 0.0};
  if (value.type == Json::Type::string) {
    if (!value.string.starts_with("layer:") || value.string.size() == 6) reader.fail(key, "must be numbers, \"layer:NAME\" or {\"texture\": FILE}");
    return LayerValue{value.string.substr(6)};
  }
  if (parameter.components == 1) return std::vector<double>{*reader.number(key)};
  return *reader.numbers(key, parameter.components, true);
}

Material read_material(const ObjectReader& reader, const std::string& name, const std::filesystem::path& folder) {
  const auto lobe = [&](std::string_view key) {
    const std::string lobe_name = reader.string(key).value_or("");
    return lobe_name == "auto" ? std::string() : lobe_name;
  };
  const Names terms = {"diffuse", "specular", "shadowing", "fresnel", "distribution", "twosided"};
  Names keys = terms;
  add(keys, parameter_names());
  reader.allow(keys);
  Material material;
  material.diffuse = lobe("diffuse");
  material.specular = lobe("specular");
  material.shadowing = reader.string("shadowing").value_or("");
  material.fresnel = reader.string("fresnel").value_or("");
  material.distribution = reader.string("distribution").value_or("");
  material.twosided = reader.boolean("twosided");
  for (const Json::Member& member : reader.json().members)
    if (!contains(terms, member.key)) material.parameters[member.key] = read_value(reader, member.key, member.value, name, folder);
  if (const auto problem = problem_of(material)) reader.fail(problem->key, problem->what);
  return material;
}

/// Decimal, as printed: "007" would be a second name of 7.
std::optional<std::uint32_t> id_of(const std::string& text) {
  std::uint32_t id = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), id);
  if (error != std::errc() || end != text.data() + text.size() || std::to_string(id) != text) return {};
  return id;
}

std::vector<double> numbers_of(const std::string& text, const std::string& assignment) {
  std::vector<double> numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    double number = 0;
    const auto [last, error] = std::from_chars(text.data() + begin, text.data() + end, number);
    if (error != std::errc() || last != text.data() + end || !std::isfinite(number))
      throw Error(ErrorKind::input, "--set " + assignment + ": " + in_quotes(text.substr(begin, end - begin)) + " is not a number");
    numbers.push_back(number);
    begin = end + 1;
  }
  return numbers;
}

bool truth_of(const std::string& text, const std::string& assignment) {
  if (text == "true" || text == "1") return true;
  if (text == "false" || text == "0") return false;
  throw Error(ErrorKind::input, "--set " + assignment + ": must be true or false");
}

}  // namespace

MaterialFile read_materials(const std::filesystem::path& file) {
  const std::string name = shown(file);
  const Json json = parse_json(read_text(file), name);
  const ObjectReader top(json, name, "");
  top.allow({"relume", "ids", "materials"});
  top.need_version();
  MaterialFile materials;
  materials.ids = top.string("ids").value_or("");
  const ObjectReader entries(top.need("materials"), name, "materials");
  const std::filesystem::path folder = file == "-" ? std::filesystem::path() : file.parent_path();
  for (const Json::Member& entry : entries.json().members) {
    const std::optional<std::uint32_t> id = id_of(entry.key);
    if (entry.key.empty()) entries.fail(entry.line, "\"\": must be an object's id (0..4294967295) or name, or \"default\"");
    const Material material = read_material(ObjectReader(entry.value, name, "materials[" + in_quotes(entry.key) + "]"), name, folder);
    if (id)
      materials.by_id[*id] = material;
    else if (entry.key == "default")
      materials.fallback = material;
    else
      materials.by_name[entry.key] = material;
  }
  return materials;
}

void set_parameter(Material& material, const std::string& assignment) {
  const auto fail = [&](const std::string& what) { throw Error(ErrorKind::input, "--set " + assignment + ": " + what); };
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0) fail("must be PARAM=VALUE");
  const std::string key = assignment.substr(0, equals), text = assignment.substr(equals + 1);
  const auto term = [&](const std::vector<Term>& terms) {
    if (!find_term(terms, text)) fail("no " + key + " " + in_quotes(text) + " (has: " + listed(names_of(terms)) + ")");
    return text;
  };
  if (key == "shadowing")
    material.shadowing = term(shadowings());
  else if (key == "fresnel")
    material.fresnel = term(fresnels());
  else if (key == "distribution")
    material.distribution = term(distributions());
  else if (key == "twosided")
    material.twosided = truth_of(text, assignment);
  else {
    if (!contains(parameter_names(), key))
      fail("no parameter " + in_quotes(key) + " (has: " + listed(parameter_names()) + ", shadowing, fresnel, distribution, twosided)");
    const Parameter& parameter = parameter_named(key);
    if (parameter.is_file) {
      if (text.empty()) fail("must name a file");
      material.parameters[key] = TableValue{shared_merl(text)};
      return;
    }
    std::vector<double> numbers = parameter.is_switch ? std::vector<double>{truth_of(text, assignment) ? 1.0 : 0.0} : numbers_of(text, assignment);
    if (numbers.size() == 1) numbers.resize(parameter.components, numbers[0]);  // a grey
    if (const auto problem = problem_of_value(parameter, numbers)) fail(*problem);
    material.parameters[key] = std::move(numbers);
  }
}

void check(const Material& material, const std::string& place) {
  if (const auto problem = problem_of(material)) throw Error(ErrorKind::input, place + ": " + in_quotes(problem->key) + ": " + problem->what);
}

const Term* fresnel_of(const Material& material, const Lobe& lobe) {
  if (lobe.fresnels.empty()) return nullptr;
  const auto given = [&](const char* name) { return material.parameters.contains(name); };
  const std::string told = given("eta") || given("k") ? "conductor" : given("ior") ? "dielectric" : "";
  const std::string_view name = material.fresnel.empty() ? told : material.fresnel;
  return find_term(fresnels(), contains(lobe.fresnels, name) ? name : lobe.fresnels.front());
}

}  // namespace relume
