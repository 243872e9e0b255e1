// A microfacet lobe is its factors: f_r n.l = D G F/(4 n.v). With D normalised, G and F at most 1 (lab/term_laws.h), this leaves no constant free.
#include <algorithm>
#include <cstdio>

#include "lab/direction_pairs.h"
#include "lab/laws/list.h"

namespace relume {
namespace {

/// The distribution and the settings of the factors that a setting of the lobe ought to have.
struct Factors {
  std::string distribution;
  Setting set;
};

double width_in(const Setting& setting) {
  const std::string alpha = value_in(setting, "alpha"), roughness = value_in(setting, "roughness");
  return !alpha.empty() ? std::stod(alpha) : roughness.empty() ? 0.25 : std::pow(std::stod(roughness), 2);  // else the default's
}

Factors factors_of(const Setting& setting, const std::vector<std::string>& arguments) {
  char width[40];
  std::snprintf(width, sizeof width, "alpha=%.9g", width_in(setting));
  Factors factors{value_in(setting, "distribution"), {width}};
  for (const std::string& argument : arguments) {
    if (find_term(distributions(), argument)) factors.distribution = argument;
    if (find_term(shadowings(), argument)) factors.set.push_back("shadowing=" + argument);
  }
  const std::string fresnel = value_in(setting, "fresnel");
  // A lobe with a Fresnel term of its own is tried as a white metal, which reflects all.
  if (fresnel.empty()) return {factors.distribution, with_others(factors.set, {"fresnel=none", "ks=1"})};
  for (const std::string& assignment : setting)
    if (!assignment.starts_with("alpha=") && !assignment.starts_with("roughness=")) factors.set.push_back(assignment);
  return factors;
}

/// With what would hide the factors taken away; a surface of ior 1 mirrors nothing at all.
Setting bare(const Examined& lobe, const Setting& setting) {
  Setting all = setting;
  if (!value_in(setting, "fresnel").empty()) return all;
  for (const char* assignment : {"metallic=1", "clearcoat=0", "ior=1.5"})
    if (std::find(lobe.parameters.begin(), lobe.parameters.end(), std::string(assignment, std::string(assignment).find('='))) !=
        lobe.parameters.end())
      all = with_others(all, {assignment});
  return all;
}

}  // namespace

Deviation law_facets(const Examined& lobe, const std::vector<std::string>& arguments) {
  Deviation deviation;
  const std::vector<DirectionPair> pairs = direction_pairs();
  std::vector<Setting> settings;
  for (const Setting& setting : lobe.grid)
    // Below, each lobe has its own least width.
    if (width_in(setting) >= 0.002 && value_in(setting, "distribution") != "multi_ggx") settings.push_back(bare(lobe, setting));
  std::sort(settings.begin(), settings.end());
  settings.erase(std::unique(settings.begin(), settings.end()), settings.end());
  for (const Setting& setting : settings) {
    const Factors factors = factors_of(setting, arguments);
    const std::vector<Reflectance> values = lobe.with(setting)(pairs);
    const std::vector<TermValues> terms = lobe.terms(factors.distribution, factors.set)(pairs);
    for (std::size_t i = 0; i < pairs.size(); ++i)
      for (int k = 0; k < 3; ++k) {
        const double whole = values[i].total()[k], product = terms[i].d * terms[i].g * terms[i].f[k] / (4 * pairs[i].v.z);
        // Far from the peak Beckmann's exponential magnifies the last bit of the width: below 1e-9 nothing is compared.
        deviation.see(std::abs(whole - product) / (std::max(whole, product) + 1e-9), text_of(setting) + ", " + text_of(pairs[i]));
      }
  }
  return deviation;
}

}  // namespace relume
