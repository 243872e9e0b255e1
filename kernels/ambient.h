// Ambient light: the same radiance from everywhere. What leaves is that radiance times the BRDF's directional albedo, integrated over the
// hemisphere by a fixed quadrature that the host makes (host/ambient_nodes.cpp; every lobe is mirror-symmetric about the plane of v).
// The diffuse lobe takes directions with pdf cos/pi; the specular one the facets that v sees on a GGX surface as wide as the lobe, bounded to those
// that reflect above the horizon: Eto and Tokuyoshi 2023, "Bounded VNDF Sampling for Smith-GGX Reflections". That bound leaves the integrand nearly
// smooth, where facets drawn by D n.h reflect many of the nodes below the horizon, at a step.
#ifndef RELUME_AMBIENT_H
#define RELUME_AMBIENT_H

#include "kernels/brdf.h"
#include "kernels/frame.h"
#include "kernels/microfacet/width.h"

typedef struct {
  real3 t, b, n;
} Basis;

/// Right-handed, t in the plane of n and v; where v is along n, t is any perpendicular.
RELUME_FN Basis basis_of(real3 n, real3 v) {
  const real3 in_plane = subtract3(v, scale3(n, dot3(n, v)));
  const mask x_is_near = absolute(n.x) > 0.5f;
  const real3 other =
      real3_of(choose(x_is_near, all_lanes(0.0f), all_lanes(1.0f)), choose(x_is_near, all_lanes(1.0f), all_lanes(0.0f)), all_lanes(0.0f));
  const real3 perpendicular = subtract3(other, scale3(n, dot3(n, other)));
  Basis basis;
  basis.n = n;
  basis.t = unit3(choose3(dot3(in_plane, in_plane) > 1e-10f, in_plane, perpendicular));
  basis.b = real3_of(n.y * basis.t.z - n.z * basis.t.y, n.z * basis.t.x - n.x * basis.t.z, n.x * basis.t.y - n.y * basis.t.x);
  return basis;
}

RELUME_FN real3 out_of(Basis basis, real x, real y, real z) { return add3(scale3(basis.n, z), add3(scale3(basis.t, x), scale3(basis.b, y))); }

/// The width of the half vectors' distribution that suits the lobe.
RELUME_FN real lobe_width(int rule, int specular, Surface s) {
  if (specular == SPECULAR_merl) return all_lanes(0.25f);  // a table states no width: one at which matt and glossy ones are told well (docs/lab.md)
  if (rule == WIDTH_exponent) return square_root(2.0f / (s.exponent + 2.0f));
  if (rule == WIDTH_chord_exponent) return square_root(2.0f / (4.0f * s.exponent + 2.0f));  // R_v turns twice as fast as h
  const float least = specular == SPECULAR_principled ? 1e-3f : 1e-5f;                      // Mitsuba's and Cycles'
  if (rule == WIDTH_roughness) return larger(squared(s.roughness), all_lanes(least));
  return width_of(s);
}

RELUME_FN real3 diffuse_albedo(Choice choice, RELUME_GLOBAL const Frame* frame, Surface s, Basis basis) {
  if (choice.diffuse == DIFFUSE_lambert) return s.albedo;
  real3 sum = grey(all_lanes(0.0f));
  for (int k = 0; k < frame->node_count; ++k) {
    RELUME_GLOBAL const float* node = s.tables + frame->nodes + 4 * k;
    const real cosine = square_root(all_lanes(1.0f - node[0])), sine = square_root(all_lanes(node[0]));
    const real3 l = out_of(basis, sine * node[1], sine * node[2], cosine);
    const Cosines c = cosines_of(s.n, l, s.v);
    sum = add3(sum, scale3(reflect_diffuse(choice.diffuse, c, s), node[3] * RELUME_PI / c.n_l));
  }
  return sum;
}

/// The viewer before a surface that is stretched by 1/width, where the visible facets are those of a hemisphere.
typedef struct {
  real width;
  real x, z;        // of the stretched unit direction to the viewer, in the plane of n and v
  real span;        // z of the cap that its reflections fill: from 1 down by this
  real normaliser;  // 1/pdf of a direction l is this over D of its half vector
} StretchedView;

RELUME_FN StretchedView stretched_view(real width, real n_v, real sine_v) {
  StretchedView view;
  const real length = square_root(squared(width * sine_v) + squared(n_v));
  const real a2 = squared(smaller(width, all_lanes(1.0f))), s2 = squared(1.0f + sine_v);
  const real k = (1.0f - a2) * s2 / (s2 + a2 * squared(n_v));
  view.width = width;
  view.x = width * sine_v / length;
  view.z = n_v / length;
  view.span = 1.0f + k * view.z;
  view.normaliser = 2.0f * (k * n_v + length);
  return view;
}

/// A facet's normal among those that the viewer sees and that reflect above the horizon, in the basis, not yet of unit length: u and phi pick a
/// direction of the stretched cap, evenly.
RELUME_FN real3 visible_facet(StretchedView view, real u, real cos_phi, real sin_phi) {
  const real down = u * view.span;                      // 1 - z on the cap
  const real sine = square_root(down * (2.0f - down));  // sqrt(1 - z^2) without its cancellation
  return real3_of(view.width * (sine * cos_phi + view.x), view.width * (sine * sin_phi), 1.0f - down + view.z);
}

RELUME_FN real3 specular_albedo(Choice choice, RELUME_GLOBAL const Frame* frame, Surface s, Basis basis) {
  real3 sum = grey(all_lanes(0.0f));
  if (choice.specular == SPECULAR_none) return sum;
  const StretchedView view = stretched_view(lobe_width(frame->width_rule, choice.specular, s), s.n_v, dot3(s.v, basis.t));
  const real a2 = squared(view.width);
  for (int k = 0; k < frame->node_count; ++k) {
    RELUME_GLOBAL const float* node = s.tables + frame->nodes + 4 * k;
    const real3 m = visible_facet(view, all_lanes(node[0]), all_lanes(node[1]), all_lanes(node[2]));
    const real across2 = squared(m.x) + squared(m.y), length2 = across2 + squared(m.z);
    const real3 h = scale3(out_of(basis, m.x, m.y, m.z), 1.0f / square_root(length2));
    const real v_dot_h = dot3(s.v, h);
    const Cosines c = cosines_of(s.n, subtract3(scale3(h, 2.0f * v_dot_h), s.v), s.v);
    // 1/D = pi (across2 + a^2 z^2)^2/(a^2 length^4)
    const real per_pdf = view.normaliser * RELUME_PI * squared((across2 + a2 * squared(m.z)) / length2) / a2;
    const mask above = (c.n_l > 0.0f) & (v_dot_h > 0.0f);
    const real3 value = scale3(reflect_specular(choice.specular, c, s), node[3] * per_pdf);
    sum = add3(sum, choose3(above, value, grey(all_lanes(0.0f))));
  }
  return sum;
}

/// Radiance that the ambient light sends to the viewer.
RELUME_FN real3 reflect_ambient(Choice choice, RELUME_GLOBAL const Frame* frame, Surface s, mask diffuse_seen, mask specular_seen) {
  const real3 dark = grey(all_lanes(0.0f));
  if (frame->ambient[3] == 0.0f) return dark;
  const Basis basis = basis_of(s.n, s.v);
  const real3 diffuse = choose3(diffuse_seen, diffuse_albedo(choice, frame, s, basis), dark);
  const real3 specular = choose3(specular_seen, specular_albedo(choice, frame, s, basis), dark);
  const real3 radiance = real3_of(all_lanes(frame->ambient[0]), all_lanes(frame->ambient[1]), all_lanes(frame->ambient[2]));
  return multiply3(radiance, add3(diffuse, specular));
}

#endif
