// Laws of D and G.
#include "lab/term_laws.h"

#include <algorithm>
#include <numbers>

#include "lab/direction_pairs.h"
#include "lab/facet_integral.h"

namespace relume {
namespace {

constexpr double pi = std::numbers::pi;
constexpr std::array widths{"0.0001", "0.001", "0.01", "0.05", "0.25", "0.5", "1"};

std::string width(const char* alpha) { return std::string("alpha=") + alpha; }

/// The integral of max(v.h, 0) over the azimuth of h, of a + b cos.
double visible_ring(const glm::dvec3& v, const glm::dvec3& h) {
  const double a = v.z * h.z, b = std::sqrt((1 - v.z * v.z) * (1 - h.z * h.z));
  if (a >= b) return 2 * pi * a;
  const double edge = std::acos(-a / b);
  return 2 * (a * edge + b * std::sin(edge));
}

}  // namespace

Deviation distribution_normalised(const TermsWith& terms) {
  Deviation deviation;
  for (const char* alpha : widths) {
    const TermsOf at = terms({width(alpha)});
    const double area = projected_area([&](std::span<const DirectionPair> pairs) {
      std::vector<double> d;
      for (const TermValues& value : at(pairs)) d.push_back(value.d);
      return d;
    });
    deviation.see(std::abs(area - 1), width(alpha));
  }
  return deviation;
}

Deviation distribution_of_facets(const TermsWith& terms) {
  Deviation deviation;
  std::vector<DirectionPair> pairs, facets;
  for (const DirectionPair& pair : direction_pairs()) {
    const glm::dvec3 sum = pair.l + pair.v;
    const double length = std::sqrt(sum.x * sum.x + sum.y * sum.y + sum.z * sum.z);
    if (length < 1e-3) continue;  // nearly opposite directions: h is lost in their rounding
    pairs.push_back(pair);
    facets.push_back({sum / length, sum / length});
  }
  for (const char* alpha : widths) {
    const TermsOf at = terms({width(alpha)});
    const std::vector<TermValues> here = at(pairs), facing = at(facets);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const double a = here[i].d, b = facing[i].d;
      const double below = a < 0 ? 1 : 0;
      deviation.see(std::max(below, std::abs(a - b) / (std::max(a, b) + 1e-30)), width(alpha) + ", " + text_of(pairs[i]));
    }
  }
  return deviation;
}

Deviation weak_furnace(const TermsWith& terms) {
  Deviation deviation;
  for (const char* alpha : widths)
    for (const double angle : {0.0, 30.0, 60.0, 80.0, 88.0}) {
      const glm::dvec3 v = direction_at(std::cos(angle * pi / 180), 0);
      const DirectionPair along_normal{{0, 0, 1}, v};
      const TermsOf at = terms({width(alpha)});
      const double visible = projected_area([&](std::span<const DirectionPair> pairs) {
        std::vector<double> values;
        for (const TermValues& value : at(pairs)) {
          const glm::dvec3& h = pairs[values.size()].l;
          values.push_back(value.d * visible_ring(v, h) / (2 * pi * h.z));
        }
        return values;
      });
      const double masked = at(std::span(&along_normal, 1)).front().g * visible / v.z;
      deviation.see(std::abs(masked - 1), width(alpha) + ", " + text_of(along_normal));
    }
  return deviation;
}

Deviation shadowing_bounded(const TermsWith& terms, bool smith) {
  Deviation deviation;
  std::vector<DirectionPair> pairs = direction_pairs(), of_light, of_view;
  for (const DirectionPair& pair : pairs) {
    of_light.push_back({{0, 0, 1}, pair.l});
    of_view.push_back({{0, 0, 1}, pair.v});
  }
  const DirectionPair straight = facing(1);
  for (const char* alpha : widths) {
    const TermsOf at = terms({width(alpha)});
    deviation.see(std::abs(at(std::span(&straight, 1)).front().g - 1), width(alpha) + ", straight on");
    const std::vector<TermValues> g = at(pairs), light = at(of_light), view = at(of_view);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const DirectionPair& pair = pairs[i];
      const glm::dvec3 sum = pair.l + pair.v;
      // n.h/v.h = 2 (n.l + n.v)/|v+l|^2
      const double groove = 4 * sum.z / (sum.x * sum.x + sum.y * sum.y + sum.z * sum.z) * std::min(pair.l.z, pair.v.z);
      const double most = smith ? std::min(light[i].g, view[i].g) : groove;
      deviation.see(std::max({-g[i].g, g[i].g - 1, g[i].g - most}), width(alpha) + ", " + text_of(pair));
    }
  }
  return deviation;
}

}  // namespace relume
