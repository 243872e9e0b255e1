// The factors of microfacet lobes, asked of the kernels for pairs of directions: the distribution of normals D, shadowing and masking G, Fresnel F.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "lab/brdf.h"

namespace relume {

struct TermValues {
  double d, g;
  glm::dvec3 f;
};

using TermsOf = std::function<std::vector<TermValues>(std::span<const DirectionPair>)>;

/// `distribution` by name; `set` as for a microfacet lobe: shadowing=NAME, fresnel=NAME, alpha=VALUE, f0=... Error{input}.
TermsOf terms_of(const std::string& distribution, const std::vector<std::string>& set, std::shared_ptr<Device> device);

}  // namespace relume
