// Principled's clear coat adds 0.25 clearcoat D F G; its D, taken from what it adds at l = v = h, where F is 0.04, is a distribution of normals.
#include "lab/facet_integral.h"
#include "lab/laws/list.h"

namespace relume {

Deviation law_clearcoat(const Examined& lobe, const std::vector<std::string>&) {
  Deviation deviation;
  const TermsOf terms = lobe.terms("ggx", {"alpha=0.25", "shadowing=smith_separable"});  // the coat's G has this width whatever its D's
  for (const double gloss : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const Setting setting{"albedo=1", "roughness=1", "clearcoat_gloss=" + std::to_string(gloss)};
    const ReflectanceOf coated = lobe.with(with_others(setting, {"clearcoat=1"})), bare = lobe.with(with_others(setting, {"clearcoat=0"}));
    const double area = projected_area([&](std::span<const DirectionPair> pairs) {
      const std::vector<Reflectance> with = coated(pairs), without = bare(pairs);
      const std::vector<TermValues> g = terms(pairs);
      std::vector<double> d;
      for (std::size_t i = 0; i < pairs.size(); ++i) d.push_back((with[i].total().x - without[i].total().x) / pairs[i].l.z / (0.25 * 0.04 * g[i].g));
      return d;
    });
    deviation.see(std::abs(area - 1), text_of(setting));
  }
  return deviation;
}

}  // namespace relume
