// Ambient light: the same radiance from everywhere. What leaves is that radiance times the BRDF's directional albedo, integrated over the
// hemisphere by a fixed quadrature that the host makes (Gauss-Legendre in u, midpoints in phi; every lobe is mirror-symmetric about the plane of v).
// The diffuse lobe takes directions with pdf cos/pi; the specular one half vectors with the pdf of GGX (Walter et al. 2007) as wide as the lobe.
#ifndef RELUME_AMBIENT_H
#define RELUME_AMBIENT_H

#include "kernels/brdf.h"
#include "kernels/frame.h"

typedef struct {
  real3 t, b, n;
} Basis;

/// Right-handed, t in the plane of n and v; where v is along n, t is any perpendicular.
RELUME_FN Basis basis_of(real3 n, real3 v) {
  const real3 in_plane = subtract3(v, scale3(n, dot3(n, v)));
  const mask x_is_near = absolute(n.x) > 0.5f;
  const real3 other = real3_of(choose(x_is_near, all_lanes(0.0f), all_lanes(1.0f)), choose(x_is_near, all_lanes(1.0f), all_lanes(0.0f)), all_lanes(0.0f));
  const real3 perpendicular = subtract3(other, scale3(n, dot3(n, other)));
  Basis basis;
  basis.n = n;
  basis.t = unit3(choose3(dot3(in_plane, in_plane) > 1e-10f, in_plane, perpendicular));
  basis.b = real3_of(n.y * basis.t.z - n.z * basis.t.y, n.z * basis.t.x - n.x * basis.t.z, n.x * basis.t.y - n.y * basis.t.x);
  return basis;
}

/// The unit direction with tan^2 of its angle to n, at the azimuth given.
RELUME_FN real3 direction_at(Basis basis, real tan2, float cos_phi, float sin_phi) {
  const real cosine = 1.0f / square_root(1.0f + tan2);
  const real sine = square_root(tan2) * cosine;
  return add3(scale3(basis.n, cosine), add3(scale3(basis.t, sine * cos_phi), scale3(basis.b, sine * sin_phi)));
}

/// The width of the half vectors' distribution that suits the lobe.
RELUME_FN real lobe_width(int rule, Surface s) {
  if (rule == WIDTH_exponent) return square_root(2.0f / (s.exponent + 2.0f));
  if (rule == WIDTH_chord_exponent) return square_root(2.0f / (4.0f * s.exponent + 2.0f));  // R_v turns twice as fast as h
  if (rule == WIDTH_roughness) return larger(squared(s.roughness), all_lanes(1e-3f));
  return larger(s.alpha, all_lanes(1e-3f));
}

RELUME_FN real3 diffuse_albedo(Choice choice, RELUME_GLOBAL const Frame* frame, Surface s, Basis basis) {
  if (choice.diffuse == DIFFUSE_lambert) return s.albedo;
  real3 sum = grey(all_lanes(0.0f));
  for (int k = 0; k < frame->node_count; ++k) {
    RELUME_GLOBAL const float* node = s.tables + frame->nodes + 4 * k;
    const real3 l = direction_at(basis, all_lanes(node[0]), node[1], node[2]);
    const Cosines c = cosines_of(s.n, l, s.v);
    sum = add3(sum, scale3(reflect_diffuse(choice.diffuse, c, s), node[3] * RELUME_PI / c.n_l));
  }
  return sum;
}

RELUME_FN real3 specular_albedo(Choice choice, RELUME_GLOBAL const Frame* frame, Surface s, Basis basis) {
  real3 sum = grey(all_lanes(0.0f));
  if (choice.specular == SPECULAR_none) return sum;
  const real a2 = squared(lobe_width(frame->width_rule, s));
  for (int k = 0; k < frame->node_count; ++k) {
    RELUME_GLOBAL const float* node = s.tables + frame->nodes + 4 * k;
    const real tan2 = a2 * node[0];
    const real3 h = direction_at(basis, tan2, node[1], node[2]);
    const real v_dot_h = dot3(s.v, h);
    const Cosines c = cosines_of(s.n, subtract3(scale3(h, 2.0f * v_dot_h), s.v), s.v);
    // 1/pdf of l: 4 v.h / (D n.h), D of GGX
    const real root = 1.0f + tan2, wide = tan2 + a2;
    const real per_pdf = 4.0f * v_dot_h * RELUME_PI * squared(wide) * square_root(root) / (a2 * squared(root));
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
