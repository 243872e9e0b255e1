// tabulate: one theta_h at a time, so that no more than a layer's pairs of directions are in memory.
#include "lab/tabulate.h"

#include <cmath>

#include "gbuffer/watched.h"

namespace relume {

DirectionPair directions_of(const MerlAngles& angles) {
  const double along = std::cos(angles.theta_d), aside = std::sin(angles.theta_d) * std::cos(angles.phi_d);
  const double y = std::sin(angles.theta_d) * std::sin(angles.phi_d), cosine = std::cos(angles.theta_h), sine = std::sin(angles.theta_h);
  return {{aside * cosine + along * sine, y, along * cosine - aside * sine}, {along * sine - aside * cosine, -y, along * cosine + aside * sine}};
}

MerlTable tabulate(const Brdf& brdf, int theta_h, int theta_d, int phi_d) {
  MerlTable table{theta_h, theta_d, phi_d, {}};
  for (auto& plane : table.f) plane.assign(table.entries(), -1.0f);
  for (int h = 0; h < theta_h; ++h) {
    std::vector<DirectionPair> pairs;
    std::vector<std::size_t> entries;
    for (int d = 0; d < theta_d; ++d)
      for (int phi = 0; phi < phi_d; ++phi) {
        const DirectionPair pair = directions_of(angles_of(table, h, d, phi));
        if (pair.l.z <= 0 || pair.v.z <= 0) continue;
        pairs.push_back(pair);
        entries.push_back(table.at(h, d, phi));
      }
    if (pairs.empty()) continue;
    beat();
    const std::vector<Reflectance> values = brdf.reflectance(pairs);
    for (std::size_t i = 0; i < pairs.size(); ++i)
      for (int c = 0; c < 3; ++c) table.f[std::size_t(c)][entries[i]] = float(values[i].total()[c] / pairs[i].l.z);
  }
  return table;
}

}  // namespace relume
