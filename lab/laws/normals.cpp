// A lobe that is a distribution of normals: the facets' areas, projected, are the surface. With l = v = h its f_r is the distribution.
#include "lab/facet_integral.h"
#include "lab/laws/list.h"

namespace relume {

Deviation law_normals(const Examined& lobe, const std::vector<std::string>&) {
  Deviation deviation;
  for (const Setting& setting : lobe.grid) {
    const ReflectanceOf reflectance = lobe.with(setting);
    const double area = projected_area([&](std::span<const DirectionPair> pairs) {
      std::vector<double> f_r;
      for (const Reflectance& value : reflectance(pairs)) f_r.push_back(value.total().x / pairs[f_r.size()].l.z);
      return f_r;
    });
    deviation.see(std::abs(area - 1), text_of(setting));
  }
  return deviation;
}

}  // namespace relume
