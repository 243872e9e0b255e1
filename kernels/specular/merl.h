// A measured isotropic BRDF as a table: Matusik et al. 2003, "A Data-Driven Reflectance Model", over Rusinkiewicz's half and difference angles.
#ifndef RELUME_MERL_H
#define RELUME_MERL_H

#include "kernels/cosines.h"
#include "kernels/math.h"
#include "kernels/surface.h"

// Numbers before the entries of a table: how many there are along theta_h, theta_d and phi_d (host/merl_numbers).
#define RELUME_MERL_HEADER 3

/// Where something lies among evenly spaced entries: between entry `below` and the next, `share` of the way.
typedef struct {
  real below, share;
} MerlPlace;

/// `x` of all `count` bins, in 0..1; a bin's value is that of its middle. Beyond the first and the last middle the table goes on as it is there.
RELUME_FN MerlPlace merl_place(real x, real count) {
  const real at = smaller(larger(x * count - 0.5f, all_lanes(0.0f)), count - 1.0f);
  MerlPlace place;
  place.below = smaller(whole_below(at), count - 2.0f);
  place.share = at - place.below;
  return place;
}

/// theta_h is spaced by its square root, so that bins are narrow where highlights are; from the tangent, which holds small angles.
RELUME_FN real merl_theta_h(Cosines c) {
  const real cosine2 = n_h_squared(c), cosine = square_root(cosine2);
  return square_root(acute_angle(cosine, c.tan2_h * cosine2 / (1.0f + cosine)) * (2.0f * RELUME_INVERSE_PI));
}

RELUME_FN real merl_theta_d(Cosines c) {
  const real cosine = smaller(v_h(c), all_lanes(1.0f)), sine2 = larger(1.0f - 0.25f * c.sum2, all_lanes(0.0f));
  return acute_angle(cosine, sine2 / (1.0f + cosine)) * (2.0f * RELUME_INVERSE_PI);
}

/// n.v - n.l = 2 sin theta_h sin theta_d cos phi_d. Three cosines do not tell phi_d from its mirror image, nor does a reciprocal BRDF tell l from v:
/// 0..pi/2 is all there is. Where h = n or l = v there is no phi_d; any will do, as the BRDF is the same for all.
RELUME_FN real merl_phi_d(Cosines c) {
  const real sines2 = larger(c.across2 * (4.0f - c.sum2), all_lanes(1e-30f));
  const real cosine2 = smaller(squared(c.n_v - c.n_l) * c.sum2 / sines2, all_lanes(1.0f)), cosine = square_root(cosine2);
  return acute_angle(cosine, (1.0f - cosine2) / (1.0f + cosine)) * (2.0f * RELUME_INVERSE_PI);
}

RELUME_FN real3 merl_entry(Surface s, integer at) { return real3_of(gather(s.tables, at), gather(s.tables, at + 1), gather(s.tables, at + 2)); }

/// Between entry `at` and the next along phi_d, then along theta_d.
RELUME_FN real3 merl_face(Surface s, integer at, integer row, MerlPlace d, MerlPlace phi) {
  const real3 low = mix3(merl_entry(s, at), merl_entry(s, at + 3), phi.share);
  const real3 high = mix3(merl_entry(s, at + row), merl_entry(s, at + row + 3), phi.share);
  return mix3(low, high, d.share);
}

/// f_r n.l, f_r trilinear in the table's own coordinates; 0 without a table.
RELUME_FN real3 specular_merl(Cosines c, Surface s) {
  const mask has = s.table >= 0.0f;
  if (!any_of(has)) return grey(all_lanes(0.0f));
  // Pixels of other programs go through here in lanes that nobody keeps: two entries a side stay within any table buffer.
  const integer start = to_integer(larger(s.table, all_lanes(0.0f)));
  const real two = all_lanes(2.0f), count_h = larger(gather(s.tables, start), two), count_d = larger(gather(s.tables, start + 1), two);
  const real count_phi = larger(gather(s.tables, start + 2), two);
  const MerlPlace h = merl_place(merl_theta_h(c), count_h), d = merl_place(merl_theta_d(c), count_d), phi = merl_place(merl_phi_d(c), count_phi);
  const integer row = to_integer(3.0f * count_phi), layer = to_integer(count_d) * row;
  const integer at = start + RELUME_MERL_HEADER + to_integer(h.below) * layer + to_integer(d.below) * row + to_integer(3.0f * phi.below);
  const real3 f = mix3(merl_face(s, at, row, d, phi), merl_face(s, at + layer, row, d, phi), h.share);
  return choose3(has, scale3(f, c.n_l), grey(all_lanes(0.0f)));
}

#endif
