// directional_albedos: cubature over the polar angle of l and its azimuth from the plane of mirror reflection, from rectangles nested around R_v.
#include "lab/directional_albedo.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>

#include "lab/cubature.h"

namespace relume {
namespace {

constexpr double pi = std::numbers::pi;

/// x is the polar angle, 0..pi/2, y the azimuth from R_v's, 0..pi: the other half of the hemisphere is alike.
/// The peak of the sharpest lobe (alpha 1e-4) must not fall between points, so rectangles around R_v grow from there by threes until they are the
/// hemisphere. A facet that tilts aside by t turns R_v by 2 t n.v aside only, so each is narrower in azimuth.
std::vector<Rectangle> rectangles_around_mirror(double cos_view) {
  constexpr double least = 1e-4, growth = 3;
  const double theta = std::acos(std::min(cos_view, 1.0)), aside = cos_view / std::max(std::sin(theta), 1e-12);
  const auto around = [&](double width) {
    return Rectangle{{std::max(0.0, theta - width), 0}, {std::min(pi / 2, theta + width), std::min(pi, width * aside)}};
  };
  double width = least;
  Rectangle inner = around(width);
  std::vector<Rectangle> all{inner};
  while (inner.low.x > 0 || inner.high.x < pi / 2 || inner.high.y < pi) {
    const Rectangle outer = around(width *= growth);
    if (outer.low.x < inner.low.x) all.push_back({outer.low, {inner.low.x, outer.high.y}});
    if (outer.high.x > inner.high.x) all.push_back({{inner.high.x, 0}, outer.high});
    if (outer.high.y > inner.high.y) all.push_back({{inner.low.x, inner.high.y}, {inner.high.x, outer.high.y}});
    inner = outer;
  }
  return all;
}

/// Cut where axis is `at`.
std::vector<Rectangle> cut(const std::vector<Rectangle>& all, int axis, double at) {
  std::vector<Rectangle> parts;
  for (Rectangle r : all) {
    if (r.low[axis] < at && at < r.high[axis]) {
      parts.push_back(r);
      parts.back().high[axis] = r.low[axis] = at;
    }
    parts.push_back(r);
  }
  return parts;
}

/// In pieces of at most pi/8: in a larger one a lobe's edge (where R_v.l = 0, say) may cut off a corner that no point sees.
std::vector<Rectangle> in_pieces(const std::vector<Rectangle>& all) {
  std::vector<Rectangle> pieces;
  for (const Rectangle& r : all) {
    const glm::dvec2 size = r.high - r.low, count = glm::ceil(size / (pi / 8));
    for (int i = 0; i < count.x; ++i)
      for (int j = 0; j < count.y; ++j) pieces.push_back({r.low + size * glm::dvec2(i, j) / count, r.low + size * glm::dvec2(i + 1, j + 1) / count});
  }
  return pieces;
}

/// Oren-Nayar's lobes have an edge where l is as steep as v, and another at right angles to its plane.
std::vector<Rectangle> domain_of(double cos_view) {
  return in_pieces(cut(cut(rectangles_around_mirror(cos_view), 0, std::acos(std::min(cos_view, 1.0))), 1, pi / 2));
}

DirectionPair pair_at(double cos_view, const glm::dvec2& angles) {
  const double sine = std::sin(angles.x);
  return {{-sine * std::cos(angles.y), sine * std::sin(angles.y), std::cos(angles.x)}, {std::sqrt(1 - cos_view * cos_view), 0, cos_view}};
}

}  // namespace

std::vector<LobeAlbedos> directional_albedos(const ReflectanceOf& reflectance, std::span<const double> cos_views, double tolerance) {
  std::vector<std::vector<Rectangle>> domains;
  for (const double cos_view : cos_views) domains.push_back(domain_of(cos_view));
  const Integrand integrand = [&](std::span<const CubaturePoint> points) {
    std::vector<DirectionPair> pairs;
    pairs.reserve(points.size());
    for (const CubaturePoint& point : points) pairs.push_back(pair_at(cos_views[point.integral], point.at));
    const std::vector<Reflectance> values = reflectance(pairs);
    std::vector<Values> weighted(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double twice_sine = 2 * std::sin(points[i].at.x);
      const glm::dvec3 diffuse = twice_sine * values[i].diffuse, specular = twice_sine * values[i].specular;
      weighted[i] = {diffuse.x, diffuse.y, diffuse.z, specular.x, specular.y, specular.z};
    }
    return weighted;
  };
  std::vector<LobeAlbedos> albedos;
  const auto colour = [](const Values& v, std::size_t first) { return glm::dvec3(v[first], v[first + 1], v[first + 2]); };
  for (const Integral& i : integrate(domains, integrand, tolerance))
    albedos.push_back({{colour(i.value, 0), colour(i.error, 0)}, {colour(i.value, 3), colour(i.error, 3)}});
  return albedos;
}

Albedo directional_albedo(const Brdf& brdf, double cos_view, double tolerance) {
  const ReflectanceOf reflectance = [&](std::span<const DirectionPair> pairs) { return brdf.reflectance(pairs); };
  return directional_albedos(reflectance, std::span(&cos_view, 1), tolerance).front().total();
}

}  // namespace relume
