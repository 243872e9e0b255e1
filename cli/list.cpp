// relume list: the lists that the kernels, the files' keys and the tests are made from.
#include <cstdio>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "gbuffer/convention.h"
#include "gbuffer/roles.h"
#include "host/lobes.h"

namespace relume {
namespace {

using Json = nlohmann::ordered_json;

Json parameter_json(std::string_view name) {
  const Parameter& p = parameter_named(name);
  if (p.is_file) return {{"name", name}, {"file", true}, {"meaning", p.meaning}};
  return {{"name", name},       {"components", p.components}, {"default", p.fallback},
          {"lowest", p.lowest}, {"highest", p.highest},       {"meaning", p.meaning}};
}

Json parameters_json(const std::vector<std::string_view>& names) {
  Json all = Json::array();
  for (const std::string_view name : names) all.push_back(parameter_json(name));
  return all;
}

Json lobe_json(const Lobe& lobe) {
  return {{"name", lobe.name},
          {"half", lobe.diffuse ? "diffuse" : "specular"},
          {"parameters", parameters_json(user_parameters(lobe))},
          {"fresnel", lobe.fresnels},
          {"shadowing", lobe.shadowings},
          {"distribution", lobe.distributions},
          {"claims", lobe.claims},
          {"source", lobe.source}};
}

Json brdfs_json() {
  Json all = Json::array(), terms = Json::array();
  for (const auto* lobes : {&diffuse_lobes(), &specular_lobes()})
    for (const Lobe& lobe : *lobes) all.push_back(lobe_json(lobe));
  for (const Term& f : fresnels()) terms.push_back({{"name", f.name}, {"parameters", parameters_json(user_parameters(f))}, {"source", f.source}});
  return {{"brdfs", all}, {"fresnel", terms}};
}

std::string joined(const Json& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : " ") + name.get<std::string>();
  return text;
}

void print_parameters(const Json& parameters) {
  for (const auto& p : parameters) {
    const std::string name = p["name"], meaning = p["meaning"];
    if (p.contains("file"))
      std::printf("      %-17s FILE: %s\n", name.c_str(), meaning.c_str());
    else
      std::printf("      %-17s %g..%g, default %g%s: %s\n", name.c_str(), p["lowest"].get<double>(), p["highest"].get<double>(),
                  p["default"].get<double>(), p["components"] == 3 ? ", rgb" : "", meaning.c_str());
  }
}

void print_brdfs(const Json& lists) {
  for (const auto& lobe : lists["brdfs"]) {
    std::printf("%-8s %-22s %s\n", lobe["half"].get<std::string>().c_str(), lobe["name"].get<std::string>().c_str(),
                lobe["source"].get<std::string>().c_str());
    print_parameters(lobe["parameters"]);
    for (const char* key : {"fresnel", "shadowing", "distribution"})
      if (!lobe[key].empty()) std::printf("      %-17s %s\n", key, joined(lobe[key]).c_str());
    std::printf("      %-17s %s\n", "plausibility", joined(lobe["claims"]).c_str());
  }
  for (const auto& term : lists["fresnel"]) {
    std::printf("fresnel  %-22s %s\n", term["name"].get<std::string>().c_str(), term["source"].get<std::string>().c_str());
    print_parameters(term["parameters"]);
  }
}

Json lights_json() {
  Json all = Json::array();
  for (const Term& light : all_light_types()) all.push_back({{"name", light.name}, {"keys", light.parameters}, {"source", light.source}});
  return all;
}

std::string known_by(const Convention& convention) {
  const std::string marks = marks_in_words(convention), shape = convention.recognised_by;
  return marks + (marks.empty() || shape.empty() ? "" : "; ") + shape;
}

Json conventions_json() {
  Json all = Json::array();
  for (const Convention& c : conventions()) all.push_back({{"name", c.name}, {"title", c.title}, {"marks", known_by(c)}, {"source", c.source}});
  return all;
}

Json roles_json() {
  Json all = Json::array();
  for (const Role& role : roles()) all.push_back({{"name", role.name}, {"components", role.components}, {"meaning", role.meaning}});
  return all;
}

std::string headline(const Json& entry) {
  for (const char* key : {"title", "meaning"})
    if (entry.contains(key)) return entry[key];
  return entry["source"];
}

int list(const std::string& what, bool as_json) {
  static const std::map<std::string, Json (*)()> makers{
      {"brdfs", brdfs_json}, {"lights", lights_json}, {"conventions", conventions_json}, {"roles", roles_json}};
  const Json lists = makers.at(what)();
  if (as_json)
    std::cout << lists.dump(2) << "\n";
  else if (what == "brdfs")
    print_brdfs(lists);
  else
    for (const auto& entry : lists) {
      std::printf("%-12s %s\n", entry["name"].get<std::string>().c_str(), headline(entry).c_str());
      if (entry.contains("keys")) std::printf("%-12s keys: %s\n", "", joined(entry["keys"]).c_str());
      if (entry.contains("marks"))
        std::printf("%-12s known by: %s\n%-12s source: %s\n", "", entry["marks"].get<std::string>().c_str(), "",
                    entry["source"].get<std::string>().c_str());
    }
  return 0;
}

}  // namespace

void add_list(CLI::App& command, Action& action) {
  struct Arguments {
    std::string what;
    bool json = false;
  };
  const auto a = std::make_shared<Arguments>();
  command.add_option("what", a->what, "brdfs, lights, conventions or roles")
      ->required()
      ->check(CLI::IsMember({"brdfs", "lights", "conventions", "roles"}));
  command.add_flag("--json", a->json, "for programs");
  command.footer("Example: relume list brdfs");
  command.callback([a, &action] { action = [a] { return list(a->what, a->json); }; });
}

}  // namespace relume
