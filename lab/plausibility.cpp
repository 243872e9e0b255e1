// findings_of: each claim looked up in the list of laws.
#include "lab/plausibility.h"

#include <algorithm>
#include <sstream>

#include "gbuffer/error.h"
#include "lab/furnace.h"
#include "lab/term_laws.h"

namespace relume {
namespace {

struct Law {
  std::string name;
  double limit;
  std::string meaning;
  Deviation (*measure)(const Examined&, const std::vector<std::string>&);
};

const std::vector<Law>& laws() {
#define RELUME_ITEM(name, limit, meaning) {#name, limit, meaning, law_##name},
  static const std::vector<Law> list{RELUME_LAWS(RELUME_ITEM)};
#undef RELUME_ITEM
  return list;
}

const Law& law_named(const std::string& name) {
  for (const Law& law : laws())
    if (law.name == name) return law;
  throw Error(ErrorKind::internal, "no law \"" + name + "\" (lab/laws/list.h)");
}

/// Asked of every lobe, whatever it claims.
constexpr std::array always{"positive", "reciprocal", "conserving"};

/// Beckmann's G1 is Walter's fit to Smith's function: up to 0.35 % from it, and up to 1.3e-4 above 1 where it is cut off.
double furnace_limit(std::string_view distribution) { return distribution == "beckmann" ? 4e-3 : 2e-6; }
double bounded_limit(std::string_view distribution, bool smith) { return distribution == "beckmann" && smith ? 1.5e-4 : 1e-6; }

}  // namespace

Claim parsed_claim(const std::string& claim) {
  std::istringstream in(claim);
  Claim parsed;
  std::getline(in, parsed.law, ':');
  for (std::string argument; std::getline(in, argument, ':');) parsed.arguments.push_back(argument);
  return parsed;
}

const std::vector<std::string>& law_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Law& law : laws()) all.push_back(law.name);
    return all;
  }();
  return names;
}

std::vector<LawFinding> findings_of(Examined& lobe) {
  lobe.furnace = furnace(lobe, lobe.grid);
  std::vector<LawFinding> findings;
  const auto ask = [&](const Claim& claim, bool claimed) {
    const Law& law = law_named(claim.law);
    const Deviation deviation = law.measure(lobe, claim.arguments);
    if (deviation.tried > 0) findings.push_back({lobe.full_name(), law.name, law.meaning, claimed, law.limit, deviation});
  };
  for (const char* law : always)
    if (std::find(lobe.claims.begin(), lobe.claims.end(), law) == lobe.claims.end()) ask({law, {}}, false);
  for (const std::string& claim : lobe.claims) ask(parsed_claim(claim), true);
  std::stable_sort(findings.begin(), findings.end(), [](const LawFinding& a, const LawFinding& b) {
    const auto place = [](const LawFinding& f) { return std::find(law_names().begin(), law_names().end(), f.law); };
    return place(a) < place(b);
  });
  return findings;
}

std::vector<LawFinding> findings_of_terms(std::shared_ptr<Device> device) {
  std::vector<LawFinding> findings;
  const auto add = [&](const std::string& subject, const std::string& law, double limit, const std::string& meaning, const Deviation& deviation) {
    findings.push_back({subject, law, meaning, true, limit, deviation});
  };
  for (const Term& d : distributions()) {
    if (d.name == "multi_ggx") continue;  // GGX's facets, with a gain
    const auto with = [&](const Setting& others) -> TermsWith {
      return [=](const Setting& set) { return terms_of(std::string(d.name), with_others(others, set), device); };
    };
    const std::string subject = "distribution " + std::string(d.name);
    add(subject, "normalised", 1e-6, "how far the integral of D n.h is from 1", distribution_normalised(with({})));
    add(subject, "facets alone", 1e-5, "how far D differs where h is the same", distribution_of_facets(with({})));
    for (const Term& g : shadowings()) {
      const std::string shadowed = subject + " " + std::string(g.name);
      const bool smith = g.name != "v_groove";
      const TermsWith terms = with({"shadowing=" + std::string(g.name)});
      add(shadowed, "bounded", bounded_limit(d.name, smith), "how far G is outside 0..1, above one of its parts, or from 1 straight on",
          shadowing_bounded(terms, smith));
      if (smith) add(shadowed, "weak furnace", furnace_limit(d.name), "how far visible facets' area is from the surface's", weak_furnace(terms));
    }
  }
  for (const Term& f : fresnels()) {
    const TermsWith terms = [&](const Setting& set) { return terms_of("ggx", set, device); };
    add("fresnel " + std::string(f.name), "bounded", 1e-6, "how far F is outside 0..1, falling, or from its ends",
        fresnel_bounded(std::string(f.name), terms));
  }
  return findings;
}

}  // namespace relume
