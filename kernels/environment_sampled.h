// An environment's light by samples of the light, of the diffuse lobe and of the specular one, weighed by the balance heuristic: Veach and Guibas
// 1995, "Optimally Combining Sampling Techniques for Monte Carlo Rendering". The points are lattices, moved by each pixel's own scramble: Cranley
// and Patterson 1976, "Randomization of Number Theoretic Methods for Multiple Integration".
#ifndef RELUME_ENVIRONMENT_SAMPLED_H
#define RELUME_ENVIRONMENT_SAMPLED_H

#include "kernels/ambient.h"
#include "kernels/bump.h"
#include "kernels/environment/add.h"
#include "kernels/environment/draw.h"
#include "kernels/load_surface.h"
#include "kernels/lookups.h"
#include "kernels/microfacet/ggx.h"

/// How many samples are drawn by the light, by the diffuse and by the specular lobe.
typedef struct {
  int light, diffuse, specular;
} Counts;

/// A diffuse lobe is so wide that the light's own samples serve it; a specular one has much for itself. All counts are even.
RELUME_FN Counts counts_of(Choice choice, int samples) {
  Counts counts;
  counts.diffuse = choice.diffuse == DIFFUSE_none ? 0 : samples / 8;
  counts.specular = choice.specular == SPECULAR_none ? 0 : samples / 8 * 3;
  counts.light = samples - counts.diffuse - counts.specular;
  return counts;
}

/// A direction of the half space above the surface, by the diffuse lobe's cosine or by the facets that the viewer sees.
RELUME_FN real3 draw_by_lobe(int diffuse, Surface s, Basis basis, StretchedView view, real u, real v) {
  const real cos_phi = cosine_of_turn(v), sin_phi = sine_of_turn(v);
  if (diffuse) return out_of(basis, square_root(u) * cos_phi, square_root(u) * sin_phi, square_root(1.0f - u));
  const real3 m = visible_facet(view, u, cos_phi, sin_phi);
  const real3 h = unit3(out_of(basis, m.x, m.y, m.z));
  return subtract3(scale3(h, 2.0f * dot3(s.v, h)), s.v);
}

typedef struct {
  real3 diffuse, specular;
  real3 apart;  // what odd samples have more than even ones: as far off as the sum, were the two independent
} Estimate;

RELUME_FN Estimate with_sample(Estimate sum, Choice choice, Surface s, StretchedView view, Counts counts, Incoming in, real3 l, int bump, int odd) {
  const Cosines c = cosines_of(s.n, l, s.v);
  real density = (float)counts.light * in.density + (float)counts.diffuse * RELUME_INVERSE_PI * c.n_l;
  if (counts.specular > 0) density = density + (float)counts.specular * ggx_distribution(c, view.width) / view.normaliser;
  real weight = 1.0f / density;
  if (bump != BUMP_none) weight = weight * bump_visibility(bump, s, l);
  const mask lit = (c.n_l > 0.0f) & (weight > 0.0f) & (density > 0.0f);
  const real3 dark = grey(all_lanes(0.0f)), light = choose3(lit, scale3(in.radiance, weight), dark);
  const real3 diffuse = choose3(lit, multiply3(light, reflect_diffuse(choice.diffuse, c, s)), dark);
  const real3 specular = choose3(lit, multiply3(light, reflect_specular(choice.specular, c, s)), dark);
  sum.diffuse = add3(sum.diffuse, diffuse);
  sum.specular = add3(sum.specular, specular);
  sum.apart = add_scaled3(sum.apart, add3(diffuse, specular), all_lanes(odd ? 1.0f : -1.0f));
  return sum;
}

RELUME_FN real fraction(real x) { return x - whole_below(x); }

RELUME_FN Estimate estimate_environment(Choice choice, RELUME_GLOBAL const float* planes, RELUME_GLOBAL const Frame* frame,
                                        RELUME_GLOBAL const float* tables, Surface s, int i) {
  RELUME_GLOBAL const EnvironmentRecord* map = &frame->environment;
  const Counts counts = counts_of(choice, map->samples);
  const Basis basis = basis_of(s.n, s.v);
  const real n_v = larger(s.n_v, all_lanes(1e-4f));  // seen from behind nothing shines; this keeps the mapping of the others finite
  const StretchedView view = stretched_view(lobe_width(frame->width_rule, choice.specular, s), n_v, dot3(s.v, basis.t));
  RELUME_GLOBAL const float* scramble = planes + (size_t)frame->plane_stride * map->scramble + i;
  const real aside = load(scramble), along = load(scramble + frame->plane_stride);
  Estimate sum;
  sum.diffuse = sum.specular = sum.apart = grey(all_lanes(0.0f));
  for (int k = 0; k < map->samples; ++k) {
    const int by_lobe = k - counts.light, by_specular = by_lobe - counts.diffuse;
    const int of = by_lobe < 0 ? counts.light : by_specular < 0 ? counts.diffuse : counts.specular;  // each a lattice of its own
    const int j = by_lobe < 0 ? k : by_specular < 0 ? by_lobe : by_specular;
    const real u = fraction(((float)j + 0.5f) / (float)of + aside), v = fraction(tables[map->points + j] + along);
    MapPlace place;
    real3 l;
    if (by_lobe < 0) {
      real cosine;
      place = draw_place(map, tables, u, v, &cosine);
      l = direction_at(&map->image, map->world_from_map, place, cosine);
    } else {
      l = draw_by_lobe(by_specular < 0, s, basis, view, u, v);
      place = place_of(&map->image, map->world_from_map, l);
    }
    sum = with_sample(sum, choice, s, view, counts, incoming_at(map, tables, place), l, frame->bump_shadowing, j & 1);
  }
  return sum;
}

/// Adds the environment's light to pixels i .. i + RELUME_LANES - 1 of those whose program this is.
RELUME_FN void environment_sampled_pixels(Choice choice, RELUME_GLOBAL const float* planes, RELUME_GLOBAL const Frame* frame,
                                          RELUME_GLOBAL const LightRecord* lights, RELUME_GLOBAL const int* lists, RELUME_GLOBAL const float* tables,
                                          RELUME_GLOBAL float* out, int i) {
  (void)lights, (void)lists;
  const mask mine = load(planes + (size_t)frame->plane_stride * frame->program_plane + i) == (float)frame->program;
  if (!any_of(mine)) return;
  const Surface s = surface_at(choice, planes, frame, tables, i);
  const Estimate sum = estimate_environment(choice, planes, frame, tables, s, i);
  add_reflection(planes, frame, s, mine, sum.diffuse, sum.specular, sum.apart, out, i);
}

#endif
