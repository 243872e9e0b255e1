// Is a BRDF plausible? Every law of the list asked of a lobe, and of the factors of microfacet lobes.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lab/laws/list.h"

namespace relume {

/// What was found of one law and one subject.
struct LawFinding {
  std::string subject;  ///< "specular ggx", "distribution beckmann"
  std::string law, meaning;
  bool claimed = true;
  double limit = 0;
  Deviation deviation;
  bool holds() const { return deviation.by <= limit; }
  bool fails() const { return claimed && !holds(); }
};

/// "law:argument:argument" of a lobe's claim.
struct Claim {
  std::string law;
  std::vector<std::string> arguments;
};
Claim parsed_claim(const std::string& claim);

/// The names of all laws, in the list's order.
const std::vector<std::string>& law_names();

/// Measures the lobe in the furnace, then its claims; of positive, reciprocal and conserving also those that it does not claim. A law that none of
/// its settings is for (a smooth surface's, where a width was fixed) is left out.
std::vector<LawFinding> findings_of(Examined& lobe);

/// Of every distribution, shadowing and Fresnel term.
std::vector<LawFinding> findings_of_terms(std::shared_ptr<Device> device);

}  // namespace relume
