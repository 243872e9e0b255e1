// relume check-brdf: is a BRDF plausible? Exit code 1 where one breaks a law that it claims.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "gbuffer/error.h"
#include "gbuffer/printable.h"
#include "gbuffer/whole_file.h"
#include "host/materials.h"
#include "lab/plausibility_report.h"

namespace relume {
namespace {

using Json = nlohmann::ordered_json;

struct CheckArguments {
  std::vector<std::string> names, set;
  std::string csv, figure, device = "twin";
  bool all = false, json = false, overwrite = false;
};

/// FILE.binary, as wherever a BRDF is named (host/brdf_name.h).
bool is_table(const std::string& name) { return name.ends_with(".binary"); }

/// Both halves where both have a lobe of the name.
std::vector<Lobe> lobes_named(const std::vector<std::string>& names) {
  std::vector<Lobe> lobes;
  std::string has;
  for (const auto* list : {&diffuse_lobes(), &specular_lobes()})
    for (const Lobe& lobe : *list) {
      has += (has.empty() ? "" : ", ") + std::string(lobe.name);
      if (names.empty() || std::find(names.begin(), names.end(), lobe.name) != names.end()) lobes.push_back(lobe);
    }
  for (const std::string& name : names)
    if (!is_table(name) && !find_lobe(true, name) && !find_lobe(false, name))
      throw Error(ErrorKind::input, "no BRDF \"" + printable(name) + "\" (has: " + has + "; the halves of a pair are examined apart)");
  return lobes;
}

/// Lobes with their grids; what a setting does not go with is left out, but Error{input} where nothing remains.
std::vector<LobeFindings> to_examine(const CheckArguments& a, const std::shared_ptr<Device>& device) {
  Material scratch;
  for (const std::string& assignment : a.set) set_parameter(scratch, assignment);  // names and ranges
  std::vector<LobeFindings> all;
  std::exception_ptr refusal;
  for (const Lobe& lobe : lobes_named(a.names)) try {
      all.push_back({examined(lobe, a.set, device), {}});
    } catch (const Error&) {
      refusal = std::current_exception();
    }
  for (const std::string& name : a.names) {
    if (!is_table(name)) continue;
    std::vector<std::string> set = a.set;
    set.push_back("table=" + name);
    all.push_back({examined(lobe_named(false, "merl"), set, device), {}});
    all.back().lobe.name = printable(name);
  }
  if (all.empty()) std::rethrow_exception(refusal);
  return all;
}

bool claims_facets(const LobeFindings& e) {
  return std::any_of(e.lobe.claims.begin(), e.lobe.claims.end(), [](const std::string& claim) { return parsed_claim(claim).law == "facets"; });
}

Json finding_json(const LawFinding& f) {
  return {{"subject", f.subject}, {"law", f.law},     {"claimed", f.claimed},       {"holds", f.holds()},
          {"by", f.deviation.by}, {"limit", f.limit}, {"where", f.deviation.where}, {"tried", f.deviation.tried},
          {"meaning", f.meaning}};
}

Json findings_json(const std::vector<LawFinding>& findings) {
  Json all = Json::array();
  for (const LawFinding& f : findings) all.push_back(finding_json(f));
  return all;
}

Json findings_json(const LobeFindings& e) {
  const FurnaceRange range = range_of(e.lobe.furnace);
  return {{"name", e.lobe.name},
          {"half", e.lobe.diffuse ? "diffuse" : "specular"},
          {"claims", e.lobe.claims},
          {"settings", e.lobe.grid.size()},
          {"furnace",
           {{"least", range.least},
            {"least_at", range.least_at},
            {"greatest", range.greatest},
            {"greatest_at", range.greatest_at},
            {"error", range.error}}},
          {"laws", findings_json(e.findings)}};
}

/// The twin has no state, so its lobes go side by side.
void examine(std::vector<LobeFindings>& lobes, const Device& device) {
  const auto one = [&](std::size_t i) { lobes[i].findings = findings_of(lobes[i].lobe); };
  if (device.info().name == "twin")
    tbb::parallel_for(std::size_t(0), lobes.size(), one);
  else
    for (std::size_t i = 0; i < lobes.size(); ++i) one(i);
}

int check_brdf(const CheckArguments& a) {
  if (a.all && !a.names.empty()) throw Error(ErrorKind::input, "--all: BRDFs are named too (give one or the other)");
  if (!a.figure.empty()) terminal_for(a.figure, {});  // the ending, before the work
  const std::shared_ptr<Device> device = lab_device(a.device);
  std::vector<LobeFindings> lobes = to_examine(a, device);
  examine(lobes, *device);
  const bool facets = std::any_of(lobes.begin(), lobes.end(), claims_facets);
  const std::vector<LawFinding> terms = facets ? findings_of_terms(device) : std::vector<LawFinding>{};
  bool plausible = std::none_of(terms.begin(), terms.end(), [](const LawFinding& f) { return f.fails(); });
  for (const LobeFindings& e : lobes)
    plausible = plausible && std::none_of(e.findings.begin(), e.findings.end(), [](const LawFinding& f) { return f.fails(); });
  if (!a.csv.empty()) write_whole(a.csv, albedo_csv(lobes), a.overwrite);
  if (!a.figure.empty()) draw(furnace_figure(lobes), a.figure, a.overwrite);
  if (a.json) {
    Json all{{"device", device->info().name}, {"plausible", plausible}, {"brdfs", Json::array()}, {"terms", findings_json(terms)}};
    for (const LobeFindings& e : lobes) all["brdfs"].push_back(findings_json(e));
    std::cout << all.dump(2) << "\n";
  } else {
    std::cout << table_text(lobes, terms);
  }
  if (!std::cout.flush()) return 5;
  return plausible ? 0 : 1;
}

}  // namespace

void add_check_brdf(CLI::App& command, Action& action) {
  const auto a = std::make_shared<CheckArguments>();
  command.add_option("names", a->names, "lobes (relume list brdfs) or measured tables, FILE.binary; default: all lobes");
  command.add_flag("--all", a->all, "every lobe and every term, as without names");
  command.add_option("--set", a->set, "PARAM=VALUE or TERM=NAME for all that take it, in place of its range");
  command.add_flag("--json", a->json, "for programs");
  command.add_option("--csv", a->csv, "the directional albedos, a row for each setting and angle");
  command.add_option("--figure", a->figure, "the ranges of the albedos, .svg, .png or .pdf");
  command.add_flag("--overwrite", a->overwrite, "allow existing files to be replaced");
  command.add_option("--device", a->device, "as for shade; default: twin, the kernels as C++, which devices are held to bit for bit");
  command.footer(
      "Exit code 1 where a BRDF breaks a law that it claims. Laws not claimed are measured too, and told.\n"
      "Example: relume check-brdf phong phong_original --figure furnace.svg");
  command.callback([a, &action] { action = [a] { return check_brdf(*a); }; });
}

}  // namespace relume
