// One compilation of bound_clusters: included by cluster_bounds_portable.cpp, ..._avx2.cpp and ..._avx512.cpp, each built for its processor.
#include <cstddef>
#include <cstring>

#include "host/cluster_bounds.h"

namespace relume {
namespace RELUME_BOUNDS_OF {
namespace {
#include "host/bounding_lanes.h"
#include "kernels/cosines.h"
#include "kernels/surface.h"
// Bounds of a measured table would be those of all entries between two: such frames are shaded without a tree (host/band_shading.cpp).
#define RELUME_MERL_H
RELUME_FN real3 specular_merl(Cosines, Surface) { return grey(real(Floats{}, plain::all_lanes(unbounded))); }
#include "kernels/brdf.h"
#include "kernels/lookups.h"

/// The patch and a ball of lights: how far apart, and between which angles.
struct Meeting {
  Floats inverse_nearest, farthest;  ///< distances; the first so large that nothing is bounded where they overlap
  real n_l, l_v;
  Floats crossing;           ///< most of n.l for a pixel whose horizon runs through the ball
  Ints dark, open, crossed;  ///< behind every pixel; before every pixel and apart from all; apart, but the horizon of some pixel may run through
};

/// Clusters side by side.
struct Side {
  Floats centre[3], radius, intensity[3];
  struct {
    Floats second[3], uneven[3], third[3], width[3];
  } one, four;
};

Floats sum_of_products(const float* a, const Floats* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// The cosines between a cone of directions and one of half-angle `cosine`, `sine` around `axis`, whose cosine to the cone's is `between`.
/// 1e-6: what rounding makes of them.
real cosines_between(const DirectionCone& cone, Floats between, Floats cosine, Floats sine) {
  const Floats one = plain::all_lanes(1), c = cosine * cone.cosine - sine * cone.sine, s = sine * cone.cosine + cosine * cone.sine;
  const Floats across = plain::square_root(most((one - between) * (one + between), Floats{}));
  // Angles that add up to more than pi are all there are.
  const Ints all = (cone.cosine + cosine < 0.0f);
  real x(between <= -c ? -one : between * c - across * s, between >= c ? one : between * c + across * s);
  x.low = all ? -one : most(x.low - 1e-6f, -one);
  x.high = all ? one : least(x.high + 1e-6f, one);
  return x;
}

Meeting meet(const PixelPatch& patch, const Side& side) {
  Meeting m;
  Floats to[3], distance2{};
  for (int c = 0; c < 3; ++c) to[c] = side.centre[c] - patch.centre[c], distance2 += to[c] * to[c];
  const Floats one = plain::all_lanes(1), distance = plain::square_root(distance2), radius = side.radius + patch.radius;
  // What rounding makes of distances is within the share of 1e-5 that the ball is larger by.
  const Floats nearest = distance - radius * 1.00001f - distance * 1e-6f;
  m.farthest = (distance + radius) * 1.00001f;
  const Ints apart = nearest > 0.0f;
  m.inverse_nearest = apart ? 1.0f / nearest : plain::all_lanes(1e12f);
  for (int c = 0; c < 3; ++c) to[c] = to[c] / distance;
  const Floats sine = apart ? least(radius / distance, one) : one, cosine = apart ? plain::square_root((one - sine) * (one + sine)) : -one;
  m.n_l = cosines_between(patch.normal, sum_of_products(patch.normal.axis, to), cosine, apart ? sine : Floats{});
  m.l_v = cosines_between(patch.view, sum_of_products(patch.view.axis, to), cosine, apart ? sine : Floats{});
  m.dark = m.n_l.high <= 0.0f;
  m.open = apart & (m.n_l.low > 0.0f);
  m.crossed = apart & ~(m.dark | m.open);
  m.crossing = least(m.n_l.high, 2.0001f * side.radius * m.inverse_nearest);
  const Floats zero{};
  m.n_l.low = most(m.n_l.low, zero), m.n_l.high = most(m.n_l.high, zero);  // the kernels reflect no other light
  m.n_l.constant = m.l_v.constant = false;
  m.n_l.by_n = m.l_v.by_v = one;
  return m;
}

real not_negative(real x) {
  x.low = most(x.low, Floats{});
  return x;
}

/// kernels/cosines.h from n.l, l.v and n.v.
Cosines cosines_of(const Meeting& m, const real& n_v) {
  Cosines c;
  c.n_l = m.n_l, c.l_v = m.l_v, c.n_v = n_v;
  c.sum2 = not_negative(2.0f + 2.0f * m.l_v);
  const real along = m.n_l + n_v;
  c.along2 = along * along;
  c.across2 = not_negative(c.sum2 - c.along2);
  c.tan2_h = smaller(c.across2 / c.along2, real(1e30f));
  c.r_l = 2.0f * m.n_l * n_v - m.l_v;
  c.chord2 = not_negative(2.0f - 2.0f * c.r_l);
  return c;
}

#define RELUME_BOUND_1(name) s.name = real(plain::all_lanes(patch.low[FIELD_##name][0]), plain::all_lanes(patch.high[FIELD_##name][0]));
#define RELUME_BOUND_3(name)                                                                                           \
  s.name = real3_of(real(plain::all_lanes(patch.low[FIELD_##name][0]), plain::all_lanes(patch.high[FIELD_##name][0])), \
                    real(plain::all_lanes(patch.low[FIELD_##name][1]), plain::all_lanes(patch.high[FIELD_##name][1])), \
                    real(plain::all_lanes(patch.low[FIELD_##name][2]), plain::all_lanes(patch.high[FIELD_##name][2])));
#define RELUME_BOUND_PARAMETER(name, components, ...) RELUME_BOUND_##components(name)

Surface surface_of(const Choice& choice, const PixelPatch& patch, const float* tables) {
  Surface s{};
  s.tables = tables;
  s.n_v = real(plain::all_lanes(patch.n_v_low), plain::all_lanes(patch.n_v_high));
  s.fresnel = choice.fresnel, s.shadowing = choice.shadowing, s.distribution = choice.distribution;
  RELUME_PARAMETERS(RELUME_BOUND_PARAMETER)
  return looked_up(choice, s);
}

#define RELUME_UNIT_1(name) s.name = real(1.0f);
#define RELUME_UNIT_3(name) s.name = grey(real(1.0f));
#define RELUME_UNIT_PARAMETER(name, components, ...) \
  if (field == FIELD_##name) RELUME_UNIT_##components(name)

/// The surface with a parameter that is 1.
Surface with_unit(Surface s, int field) {
  RELUME_PARAMETERS(RELUME_UNIT_PARAMETER)
  return s;
}

/// Most of |u.K''u| d^4 over unit vectors u, by its radial and tangential parts; see docs/maths.md.
Floats most_curvature(const real& f, const Meeting& m) {
  const auto sine = [](const real& c) {
    return plain::square_root(1.0f - least(plain::absolute(c.low), plain::absolute(c.high)) * least(plain::absolute(c.low), plain::absolute(c.high)));
  };
  const auto sine_of = [&](const real& c) { return ((c.low <= 0.0f) & (c.high >= 0.0f)) ? plain::all_lanes(1) : sine(c); };
  const Floats a = sine_of(m.n_l), b = sine_of(m.l_v), value = most(f.high, Floats{});
  const Floats tangential =
      f.by_nn * a * a + 2.0f * f.by_nv * a * b + f.by_vv * b * b + f.by_n * magnitude(m.n_l) + f.by_v * magnitude(m.l_v) + 2.0f * value;
  const Floats mixed = 3.0f * (f.by_n * a + f.by_v * b), radial = 6.0f * value;
  const Floats difference = radial - tangential;
  return 0.5f * (radial + tangential + plain::square_root(difference * difference + 4.0f * mixed * mixed));
}

struct HalfBounds {
  Floats low[3], one[3], four[3], high;
};

/// What NaN or overflow make of a bound is no bound.
Floats bounded(Floats x) { return x < unbounded ? x : plain::all_lanes(unbounded); }

/// A pixel's error: where all its lights are before it, `smooth`; where its horizon runs through them, what they can be at most there.
Floats error_of(const Meeting& m, Floats smooth, Floats crossing, Floats range) {
  return least(range, m.open ? smooth : m.crossed ? most(smooth, crossing) : range);
}

/// Of any lobe, by its values and curvature. `crossing`: its values for pixels whose horizon runs through the ball.
void bound_lobe(const real3& f, const real3& crossing, const Meeting& m, const Side& side, HalfBounds& out) {
  const real* channels[] = {&f.x, &f.y, &f.z};
  const real* crossings[] = {&crossing.x, &crossing.y, &crossing.z};
  const Floats zero{}, near = m.inverse_nearest, far = 1.0f / m.farthest;
  out.high = zero;
  for (int c = 0; c < 3; ++c) {
    const Floats low = m.open ? most(channels[c]->low, zero) : zero, high = most(channels[c]->high, zero);
    out.low[c] = m.open ? side.intensity[c] * low * far * far : zero;
    const Floats range = bounded(side.intensity[c] * (high * near * near - low * far * far));
    const Floats curved = 0.5f * most_curvature(*channels[c], m) * near * near * near * near;
    const Floats crossed = bounded(side.intensity[c] * crossings[c]->high * near * near);
    out.one[c] = error_of(m, bounded(curved * side.one.second[c]), crossed, range);
    out.four[c] = error_of(m, bounded(curved * side.four.second[c]), crossed, range);
    out.high = most(out.high, bounded(high));
  }
}

/// Of f = n.l. 4.25: half of the Frobenius norm of a K'' whose largest eigenvalue is 6/d^4 and whose trace is 0, sqrt(72)/2.
void bound_lambert(const Meeting& m, const Side& side, HalfBounds& out) {
  const Floats zero{}, near = m.inverse_nearest, far = 1.0f / m.farthest, near2 = near * near;
  for (int c = 0; c < 3; ++c) {
    out.low[c] = m.open ? side.intensity[c] * m.n_l.low * far * far : zero;
    const Floats range = bounded(side.intensity[c] * (m.n_l.high * near2 - (m.open ? m.n_l.low * far * far : zero)));
    const auto smooth = [&](const auto& moments) {
      const Floats fourth = least(3.0f * moments.second[c], 4.25f * moments.uneven[c] + 4.0f * moments.third[c] * near);
      const Floats smooth = bounded(fourth * near2 * near2);
      // max(z, 0) = (z + |z|)/2 for the height z above the horizon: see docs/maths.md.
      const Floats mean_distance = plain::square_root(2.0f * side.intensity[c] * moments.second[c]);
      const Floats kink = 0.5f * moments.width[c] * near * near2 + 1.5f * (2.0f * side.radius * mean_distance + moments.second[c]) * near2 * near2;
      return error_of(m, smooth, least(bounded(side.intensity[c] * m.crossing * near2), bounded(0.5f * smooth + kink)), range);
    };
    out.one[c] = smooth(side.one);
    out.four[c] = smooth(side.four);
  }
  out.high = m.n_l.high;
}

Side side_by_side(std::span<const LightCluster> clusters, std::span<const int> which) {
  Side side;
  for (std::size_t lane = 0; lane < RELUME_LANES; ++lane) {
    const LightCluster& cluster = clusters[std::size_t(which[lane < which.size() ? lane : 0])];
    side.radius[lane] = cluster.radius;
    for (int c = 0; c < 3; ++c) {
      side.centre[c][lane] = cluster.centre[c], side.intensity[c][lane] = cluster.intensity[c];
      side.one.second[c][lane] = cluster.one.second[c], side.four.second[c][lane] = cluster.four.second[c];
      side.one.uneven[c][lane] = cluster.one.uneven[c], side.four.uneven[c][lane] = cluster.four.uneven[c];
      side.one.third[c][lane] = cluster.one.third[c], side.four.third[c][lane] = cluster.four.third[c];
      side.one.width[c][lane] = cluster.one.width[c], side.four.width[c][lane] = cluster.four.width[c];
    }
  }
  return side;
}

void keep(const HalfBounds& half, int number, ClusterBounds& bounds) {
  for (int c = 0; c < 3; ++c) {
    plain::store(half.low[c], bounds.low[number][c]);
    plain::store(half.one[c], bounds.one[number][c]);
    plain::store(half.four[c], bounds.four[number][c]);
  }
}

}  // namespace

void bound_clusters(const Choice& choice, const PixelPatch& patch, const float* tables, std::span<const LightCluster> clusters,
                    std::span<const int> which, ClusterBounds& bounds) {
  const Side side = side_by_side(clusters, which);
  const Meeting m = meet(patch, side);
  const bool lambert = choice.diffuse == DIFFUSE_lambert || choice.diffuse == DIFFUSE_lambert_original;
  const bool shiny = choice.specular != SPECULAR_none && patch.highlights;
  HalfBounds diffuse{}, specular{};
  if (lambert) bound_lambert(m, side, diffuse);
  const bool curved = !lambert && choice.diffuse != DIFFUSE_none;
  if (shiny || curved) {
    const Surface s = surface_of(choice, patch, tables), d = with_unit(s, diffuse_factor(choice).field),
                  g = with_unit(s, specular_factor(choice).field);
    const Cosines cosines = cosines_of(m, s.n_v);
    Meeting at_horizon = m;
    at_horizon.n_l.low = Floats{}, at_horizon.n_l.high = m.crossing;
    const bool any_crossed = plain::any_of(m.crossed);
    const Cosines crossing = any_crossed ? cosines_of(at_horizon, s.n_v) : cosines;
    const auto bound = [&](const auto& reflect, const Surface& surface, HalfBounds& out) {
      const real3 f = reflect(cosines, surface);
      bound_lobe(f, any_crossed ? reflect(crossing, surface) : f, m, side, out);
    };
    if (curved) bound([&](const Cosines& c, const Surface& x) { return reflect_diffuse(choice.diffuse, c, x); }, d, diffuse);
    if (shiny) bound([&](const Cosines& c, const Surface& x) { return reflect_specular(choice.specular, c, x); }, g, specular);
  }
  keep(diffuse, half_diffuse, bounds);
  keep(specular, half_specular, bounds);
  plain::store(m.dark ? Floats{} : plain::all_lanes(1), bounds.high);
}
}  // namespace RELUME_BOUNDS_OF
}  // namespace relume
