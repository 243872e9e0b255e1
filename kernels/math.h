// Elementary functions as polynomials of exact operations, the same bits in every compiler. The coefficients are minimax fits made for this project
// (Lawson's reweighted least squares, rounded to float one after another); tests/math_test.cpp measures the errors.
#ifndef RELUME_MATH_H
#define RELUME_MATH_H

#include "kernels/vector.h"

// ln 2 in two parts (Cody and Waite 1980): the first has 9 bits, so that a whole number up to 2^15 times it is exact.
#define RELUME_LN2_HIGH 0.693359375f
#define RELUME_LN2_LOW -2.12194440e-4f

/// e^x within 1.2 ulp; 0 where it is below the smallest normal float (x < -87.34), infinity from 88.73, NaN for NaN.
/// x = n ln 2 + r with |r| <= ln 2/2; the polynomial's own error is 3e-9.
RELUME_FN real exp_of(real x) {
  const real within = clamped(x, -88.0f, 89.0f);  // keeps n within an exponent's bits, for NaN too
  const real n = whole_below(within * 1.44269504f + 0.5f);
  const real r = (within - n * RELUME_LN2_HIGH) - n * RELUME_LN2_LOW;
  real p = all_lanes(0.00138211751f);
  p = p * r + 0.00836866535f;
  p = p * r + 0.0416682586f;
  p = p * r + 0.166665211f;
  p = p * r + 0.49999994f;
  p = p * r + 1.0f;
  p = p * r + 1.0f;
  // n is added to the exponent's bits: p lies in 0.7..1.42, so n = 128 needs no second step.
  const real scaled = as_real(as_integer(p) + to_integer(n) * 0x800000);
  const real bounded = choose(x < -87.336545f, all_lanes(0.0f), choose(x > 88.722835f, all_lanes(INFINITY), scaled));
  return choose(x == x, bounded, x);
}

/// ln(1 + x) within 1.8 ulp of the result for every x > -1, however small or large; -infinity at -1 and below, NaN for NaN.
/// 1 + x = 2^k (1 + f) with f in sqrt(1/2)-1..sqrt(2)-1. f comes from x, not from the rounded 1 + x, so that nothing is lost near 0.
RELUME_FN real log1p_of(real x) {
  const real b = choose(x > -1.0f, x, all_lanes(0.0f));                   // the bits of a negative number are no exponent
  const integer shift = (as_integer(1.0f + b) - 0x3f3504f3) & -0x800000;  // 0x3f3504f3 is sqrt(1/2); this is k in the exponent's place
  const real k = to_real(shift) * 1.1920928955078125e-7f;                 // 2^-23
  const real scale = as_real(0x40800000 - shift);                         // 4 2^-k: 2^-k itself would be too small to hold for k = 128
  const real f = 0.25f * (b * scale) + (0.25f * scale - 1.0f);
  real p = all_lanes(0.0870040134f);
  p = p * f - 0.14266932f;
  p = p * f + 0.149145082f;
  p = p * f - 0.165776521f;
  p = p * f + 0.199631006f;
  p = p * f - 0.250013351f;
  p = p * f + 0.333339095f;
  const real tail = (f * f) * (f * p - 0.5f) + k * RELUME_LN2_LOW;
  const real y = (f + tail) + k * RELUME_LN2_HIGH;
  return choose(x > -1.0f, choose(x > 3.402823466e38f, x, y), choose(x == x, all_lanes(-INFINITY), x));
}

/// The angle in 0..pi whose cosine is x, within 2.7 ulp; x beyond -1..1 counts as the nearer end.
/// acos(a) = sqrt(1 - a) P(a) for a in 0..1 (the form of Hastings 1955, sheet 37) and acos(-a) = pi - acos(a).
RELUME_FN real arc_cosine(real x) {
  const real a = smaller(absolute(x), all_lanes(1.0f));
  real p = all_lanes(-0.000699530588f);
  p = p * a + 0.00473562907f;
  p = p * a - 0.0144851869f;
  p = p * a + 0.0291623939f;
  p = p * a - 0.0495876446f;
  p = p * a + 0.0888849199f;
  p = p * a - 0.214593202f;
  p = p * a + 1.57079625f;
  const real y = square_root(1.0f - a) * p;
  return choose(x < 0.0f, RELUME_PI - y, y);
}

#endif
