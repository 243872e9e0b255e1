// The lecture's directions n, v, l, R_v, R_l and h as the three cosines that every isotropic BRDF needs, with what sharp lobes need beside them.
//
//   |v+l|^2 = 2 + 2 l.v    n.h = (n.l + n.v)/|v+l|    v.h = l.h = |v+l|/2    R_v.l = R_l.v = 2 (n.l)(n.v) - l.v
//
// Cosines near 1 hold little in single precision (rounding them changes a lobe of alpha 0.05 by 8e-4), so the small quantities are made from the
// vectors, where nothing cancels: tan^2 of the angle between n and h, and the squared chord between R_v and l. What a lobe does not read, the
// compiler drops.
#ifndef RELUME_COSINES_H
#define RELUME_COSINES_H

#include "kernels/vector.h"

/// The members of Cosines that differ from light to light.
#define RELUME_COSINES(MEMBER) MEMBER(n_l) MEMBER(l_v) MEMBER(sum2) MEMBER(across2) MEMBER(along2) MEMBER(tan2_h) MEMBER(chord2) MEMBER(r_l)

typedef struct {
  real n_l, n_v, l_v;
  real sum2;     // |v+l|^2, in 0..4
  real across2;  // |v+l|^2 sin^2 of the angle between n and h: the square of the part of v+l across n
  real along2;   // |v+l|^2 cos^2 of it: (n.l + n.v)^2
  real tan2_h;   // tan^2 of it: across2/along2, at most 1e30
  real chord2;   // |R_v - l|^2 = 2 - 2 R_v.l, in 0..4
  real r_l;      // R_v.l: what chord2 rounds away where R_v.l is near 0
} Cosines;

RELUME_FN Cosines cosines_of(real3 n, real3 l, real3 v) {
  Cosines c;
  c.n_l = dot3(n, l);
  c.n_v = dot3(n, v);
  c.l_v = dot3(l, v);
  const real3 sum = add3(l, v);
  const real along = c.n_l + c.n_v;
  const real3 across = add_scaled3(sum, n, -along);
  const real3 chord = add_scaled3(sum, n, -2.0f * c.n_v);
  c.sum2 = dot3(sum, sum);
  c.across2 = dot3(across, across);
  c.along2 = along * along;
  // At the most grazing angles along2 is 0, and where l = -v both are: 1e30 stands for infinity, so that no lobe divides infinities.
  c.tan2_h = smaller(c.across2 / c.along2, all_lanes(1e30f));
  c.chord2 = dot3(chord, chord);
  c.r_l = fused(2.0f * c.n_l, c.n_v, -c.l_v);
  return c;
}

/// (n.h)^2 = 1/(1 + tan^2)
RELUME_FN real n_h_squared(Cosines c) { return 1.0f / (1.0f + c.tan2_h); }
RELUME_FN real v_h(Cosines c) { return 0.5f * square_root(c.sum2); }

#endif
