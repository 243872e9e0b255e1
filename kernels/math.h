// Elementary functions as polynomials of exact operations, the same bits in every compiler. The coefficients are minimax fits made for this project
// (Lawson's reweighted least squares, rounded to float one after another); tests/math_test.cpp measures the errors.
#ifndef RELUME_MATH_H
#define RELUME_MATH_H

#include "kernels/vector.h"

// ln 2 in two parts (Cody and Waite 1980): the first has 9 bits, so that a whole number up to 2^15 times it is exact.
#define RELUME_LN2_HIGH 0.693359375f
#define RELUME_LN2_LOW -2.12194440e-4f

/// e^x for x up to 89, within 1.2 ulp; 0 below 2^-90 (x < -62.4), NaN for NaN. A lobe that is 1e27 times weaker than at its peak
/// is not seen, and products of smaller numbers would be denormal, with which processors take ten times as long. x = n ln 2 + r with |r| <= ln 2/2;
/// the polynomial's own error is 3e-9. It is summed in pairs (Estrin 1960): the loop over lights waits for it.
RELUME_FN real exp_up_to_89(real x) {
  const real shifted = fused(x, all_lanes(1.44269504f), all_lanes(12582912.0f));  // 1.5 2^23: rounds to a whole number, in the lowest bits
  const real n = shifted - 12582912.0f;
  const real r = fused(n, all_lanes(-RELUME_LN2_LOW), fused(n, all_lanes(-RELUME_LN2_HIGH), x));
  const real r2 = r * r;
  const real fourth = fused(r2, all_lanes(0.00276423502f), fused(r, all_lanes(0.0167373307f), all_lanes(0.0833365172f)));
  const real second = fused(r2, fourth, fused(r, all_lanes(0.333330422f), all_lanes(0.99999988f)));
  // Twice e^r, by 2^(n-1): an exponent's bits hold 2^127 but not 2^128.
  const real twice = 2.0f + fused(r2, second, 2.0f * r);
  return choose(x < -62.383246f, all_lanes(0.0f), twice * as_real((as_integer(shifted) + 126) << 23));
}

/// e^x for every x: infinity from 88.73.
RELUME_FN real exp_of(real x) { return exp_up_to_89(smaller(all_lanes(89.0f), x)); }  // NaN stays NaN

/// ln(1 + x) within 1.8 ulp of the result for every finite x > -1, however small or large; NaN for NaN.
/// 1 + x = 2^k (1 + f) with f in sqrt(1/2)-1..sqrt(2)-1. f comes from x, not from the rounded 1 + x, so that nothing is lost near 0.
RELUME_FN real log1p_of(real x) {
  const integer shift = (as_integer(1.0f + x) - 0x3f3504f3) & -0x800000;  // 0x3f3504f3 is sqrt(1/2); this is k in the exponent's place
  const real k = to_real(shift) * 1.1920928955078125e-7f;                 // 2^-23
  const real scale = as_real(0x40800000 - shift);                         // 4 2^-k: 2^-k itself would be too small to hold for k = 128
  const real f = fused(all_lanes(0.25f), x * scale, fused(all_lanes(0.25f), scale, all_lanes(-1.0f)));
  const real f2 = f * f;
  const real high = fused(f2, all_lanes(0.0870040134f), fused(f, all_lanes(-0.14266932f), all_lanes(0.149145082f)));
  const real middle = fused(f2, high, fused(f, all_lanes(-0.165776521f), all_lanes(0.199631006f)));
  const real p = fused(f2, middle, fused(f, all_lanes(-0.250013351f), all_lanes(0.333339095f)));
  const real tail = fused(f2, fused(f, p, all_lanes(-0.5f)), k * RELUME_LN2_LOW);
  return fused(k, all_lanes(RELUME_LN2_HIGH), f + tail);
}

/// The angle in 0..pi/2 whose cosine is a, from a and 1 - a: near 0 it is as exact as the 1 - a that the caller has, which a itself does not hold.
/// acos(a) = sqrt(1 - a) P(a) for a in 0..1 (the form of Hastings 1955, sheet 37).
RELUME_FN real acute_angle(real a, real one_minus_a) {
  real p = all_lanes(-0.000699530588f);
  p = p * a + 0.00473562907f;
  p = p * a - 0.0144851869f;
  p = p * a + 0.0291623939f;
  p = p * a - 0.0495876446f;
  p = p * a + 0.0888849199f;
  p = p * a - 0.214593202f;
  p = p * a + 1.57079625f;
  return square_root(one_minus_a) * p;
}

/// The angle in 0..pi whose cosine is x, within 2.7 ulp; x beyond -1..1 counts as the nearer end. acos(-a) = pi - acos(a).
RELUME_FN real arc_cosine(real x) {
  const real a = smaller(absolute(x), all_lanes(1.0f));
  const real y = acute_angle(a, 1.0f - a);
  return choose(x < 0.0f, RELUME_PI - y, y);
}

/// sin(2 pi t) for t in -1..2, within 2 ulp but near its zeros, where it is within 2e-7.
RELUME_FN real sine_of_turn(real t) {
  const real a = t - whole_below(t + 0.5f);
  const real folded = choose(a > 0.25f, 0.5f - a, choose(a < -0.25f, -0.5f - a, a)), z = folded * folded;
  real p = all_lanes(40.0624657f);
  p = p * z - 76.6253281f;
  p = p * z + 81.6046448f;
  p = p * z - 41.3417206f;
  p = p * z + 6.28318548f;
  return folded * p;
}
RELUME_FN real cosine_of_turn(real t) { return sine_of_turn(t + 0.25f); }

/// The angle of (x, y) in 0..2 pi, counted from x towards y.
RELUME_FN real angle_of(real x, real y) {
  const real across = absolute(x), up = absolute(y);
  const real inverse = 1.0f / larger(square_root(across * across + up * up), all_lanes(1e-30f));
  // By the shorter side, where the arc cosine does not magnify rounding.
  const real first = choose(up > across, arc_cosine(across * inverse), 0.5f * RELUME_PI - arc_cosine(up * inverse));
  const real above = choose(x < 0.0f, RELUME_PI - first, first);
  return choose(y < 0.0f, 2.0f * RELUME_PI - above, above);
}

#endif
