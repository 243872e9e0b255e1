// From the three cosines that a person types to what the kernels' Cosines hold, in double: kernels/cosines.h has the vectors, `relume evaluate` and
// the tests have not.
#pragma once

namespace relume {

/// As in kernels/cosines.h.
struct PreciseCosines {
  double n_l, n_v, l_v;
  double sum2, across2, along2, tan2_h, chord2, r_l;
};

/// The cosines must be of directions that exist: what rounding makes negative becomes 0, and tan2_h is at most 1e30, as in the kernels.
inline PreciseCosines precise_cosines(double n_l, double n_v, double l_v) {
  PreciseCosines c{};
  c.n_l = n_l;
  c.n_v = n_v;
  c.l_v = l_v;
  const double along = n_l + n_v;
  const auto not_negative = [](double x) { return x > 0 ? x : 0; };
  c.sum2 = not_negative(2 + 2 * l_v);
  c.along2 = along * along;
  c.across2 = not_negative(c.sum2 - c.along2);
  const double tan2 = c.across2 / c.along2;
  c.tan2_h = tan2 < 1e30 ? tan2 : 1e30;
  c.r_l = 2 * n_l * n_v - l_v;
  c.chord2 = not_negative(2 - 2 * c.r_l);
  return c;
}

}  // namespace relume
