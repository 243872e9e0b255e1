// terms_of: the terms of a GGX lobe's material, with any distribution, through kernels/terms.h.
#include "lab/terms.h"

#include <algorithm>

#include "host/lobes.h"
#include "host/row_band.h"

namespace relume {

TermsOf terms_of(const std::string& distribution, const std::vector<std::string>& set, std::shared_ptr<Device> device) {
  const int number = term_named(distributions(), distribution, "distribution").number;
  // GGX takes every shadowing and Fresnel term; its own distribution is not asked.
  const auto facets = std::make_shared<Brdf>("none+ggx", set, device);
  return [=](std::span<const DirectionPair> pairs) {
    std::vector<PreciseCosines> cosines(pairs.size());
    std::transform(pairs.begin(), pairs.end(), cosines.begin(), cosines_of);
    const Planes out = RowBand(cosines).terms(*device, facets->binding(), number);
    std::vector<TermValues> values;
    values.reserve(pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i)
      values.push_back({out.plane(0)[i], out.plane(1)[i], glm::dvec3(out.plane(3)[i], out.plane(4)[i], out.plane(5)[i])});
    return values;
  };
}

}  // namespace relume
