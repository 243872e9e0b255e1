// kernels/language.h spelt once more: a number is all values that it takes over some pixels and some directions of light, with the most that its
// derivatives by n.l and l.v reach there (interval arithmetic, Moore 1966, and majorants, over jets of second order). What the kernels' own lobes
// make of such numbers bounds the lobes and their curvature, so no lobe is described twice.
// Included inside a namespace by cluster_bounds_lanes.h, before the kernels; needs <cstddef> and <cstring>.
#define RELUME_LANES 16
namespace plain {
#include "kernels/math.h"
}
#undef RELUME_VECTOR_H  // for once more, over the numbers below

using Floats = plain::real;
using Ints = plain::integer;

/// Stands for "not bounded", and leaves room for a product of two.
constexpr float unbounded = 1e18f;

static inline Floats least(Floats a, Floats b) { return a < b ? a : b; }
static inline Floats most(Floats a, Floats b) { return a > b ? a : b; }

struct real {
  Floats low{}, high{};
  Floats by_n{}, by_v{}, by_nn{}, by_nv{}, by_vv{};  ///< most of |derivative|: by n.l, by l.v, and the second ones
  bool constant = true;                              ///< the same for all directions: derivatives are 0

  real() = default;
  real(float x) : low(plain::all_lanes(x)), high(low) {}
  real(Floats l, Floats h) : low(l), high(h) {}
};

/// What a condition is: certain, impossible, or neither.
struct mask {
  Ints yes, no;
  bool constant;
};

struct integer {
  Ints low{}, high{};
  bool constant = true;
  integer() = default;
  integer(int x) : low(Ints{} + x), high(low) {}
};

static inline Floats magnitude(const real& x) { return most(plain::absolute(x.low), plain::absolute(x.high)); }

/// f(x), of values low..high: `first` and `second` bound |f'| and |f''|.
static inline real through(const real& x, Floats low, Floats high, Floats first, Floats second) {
  real y(low, high);
  if (x.constant) return y;
  y.constant = false;
  y.by_n = first * x.by_n, y.by_v = first * x.by_v;
  y.by_nn = first * x.by_nn + second * x.by_n * x.by_n;
  y.by_nv = first * x.by_nv + second * x.by_n * x.by_v;
  y.by_vv = first * x.by_vv + second * x.by_v * x.by_v;
  return y;
}

/// A number whose derivatives are not known.
static inline real rough(Floats low, Floats high) {
  real y(low, high);
  y.constant = false;
  y.by_n = y.by_v = y.by_nn = y.by_nv = y.by_vv = plain::all_lanes(unbounded);
  return y;
}

static inline real operator-(const real& a) {
  real y = a;
  y.low = -a.high, y.high = -a.low;
  return y;
}
static inline real operator+(const real& a, const real& b) {
  real y(a.low + b.low, a.high + b.high);
  if (a.constant && b.constant) return y;
  y.constant = false;
  y.by_n = a.by_n + b.by_n, y.by_v = a.by_v + b.by_v;
  y.by_nn = a.by_nn + b.by_nn, y.by_nv = a.by_nv + b.by_nv, y.by_vv = a.by_vv + b.by_vv;
  return y;
}
static inline real operator-(const real& a, const real& b) { return a + -b; }
static inline real operator*(const real& a, const real& b) {
  const Floats p = a.low * b.low, q = a.low * b.high, r = a.high * b.low, s = a.high * b.high;
  real y(least(least(p, q), least(r, s)), most(most(p, q), most(r, s)));
  if (a.constant && b.constant) return y;
  y.constant = false;
  const Floats m = magnitude(a), n = magnitude(b);
  if (a.constant || b.constant) {
    const real& x = a.constant ? b : a;
    const Floats k = a.constant ? m : n;
    y.by_n = k * x.by_n, y.by_v = k * x.by_v, y.by_nn = k * x.by_nn, y.by_nv = k * x.by_nv, y.by_vv = k * x.by_vv;
    return y;
  }
  y.by_n = m * b.by_n + a.by_n * n;
  y.by_v = m * b.by_v + a.by_v * n;
  y.by_nn = m * b.by_nn + 2.0f * a.by_n * b.by_n + a.by_nn * n;
  y.by_nv = m * b.by_nv + a.by_n * b.by_v + a.by_v * b.by_n + a.by_nv * n;
  y.by_vv = m * b.by_vv + 2.0f * a.by_v * b.by_v + a.by_vv * n;
  return y;
}
static inline real reciprocal(const real& x) {
  const Ints apart = (x.low > 0.0f) | (x.high < 0.0f);
  const Floats much = plain::all_lanes(unbounded), nearest = least(plain::absolute(x.low), plain::absolute(x.high));
  const Floats first = least(1.0f / (nearest * nearest), much), second = least(2.0f / (nearest * nearest * nearest), much);
  // 1/0 where the interval only touches 0 is infinite on that side.
  const Floats low = x.low >= 0.0f ? 1.0f / x.high : apart ? 1.0f / x.high : -much;
  const Floats high = x.low > 0.0f || x.high < 0.0f ? 1.0f / x.low : much;
  return through(x, low, high, apart ? first : much, apart ? second : much);
}
static inline real operator/(const real& a, const real& b) { return a * reciprocal(b); }
static inline real fused(const real& a, const real& b, const real& c) { return a * b + c; }

static inline mask condition(Ints yes, Ints no, const real& a, const real& b) { return {yes, no, a.constant && b.constant}; }
static inline mask operator<(const real& a, const real& b) { return condition(a.high < b.low, a.low >= b.high, a, b); }
static inline mask operator>(const real& a, const real& b) { return b < a; }
static inline mask operator<=(const real& a, const real& b) { return condition(a.high <= b.low, a.low > b.high, a, b); }
static inline mask operator>=(const real& a, const real& b) { return b <= a; }
static inline mask operator==(const real& a, const real& b) {
  return condition((a.low == a.high) & (b.low == b.high) & (a.low == b.low), (a.high < b.low) | (b.high < a.low), a, b);
}
static inline mask operator&(const mask& a, const mask& b) { return {a.yes & b.yes, a.no | b.no, a.constant && b.constant}; }
static inline mask operator|(const mask& a, const mask& b) { return {a.yes | b.yes, a.no & b.no, a.constant && b.constant}; }
static inline mask operator!(const mask& a) { return {a.no, a.yes, a.constant}; }
static inline mask operator~(const mask& a) { return !a; }

/// Where it is open which of the two holds, values of both; and no derivative, unless it is the pixel that decides.
static inline real choose(const mask& m, const real& a, const real& b) {
  real y(m.yes ? a.low : m.no ? b.low : least(a.low, b.low), m.yes ? a.high : m.no ? b.high : most(a.high, b.high));
  if (m.constant && a.constant && b.constant) return y;
  y.constant = false;
  const auto either = [&](Floats p, Floats q) { return m.yes ? p : m.no ? q : m.constant ? most(p, q) : plain::all_lanes(unbounded); };
  y.by_n = either(a.by_n, b.by_n), y.by_v = either(a.by_v, b.by_v);
  y.by_nn = either(a.by_nn, b.by_nn), y.by_nv = either(a.by_nv, b.by_nv), y.by_vv = either(a.by_vv, b.by_vv);
  return y;
}
static inline real square_root(const real& x) {
  const Floats zero{}, much = plain::all_lanes(unbounded), low = plain::square_root(most(x.low, zero)), high = plain::square_root(most(x.high, zero));
  return through(x, low, high, least(0.5f / low, much), least(0.25f / (low * low * low), much));
}
static inline real absolute(const real& x) {
  const Ints straddles = (x.low < 0.0f) & (x.high > 0.0f);
  const Floats zero{}, one = plain::all_lanes(1), much = plain::all_lanes(unbounded);
  return through(x, straddles ? zero : least(plain::absolute(x.low), plain::absolute(x.high)), magnitude(x), straddles ? much : one,
                 straddles ? much : zero);
}
static inline real whole_below(const real& x) {
  const Floats low = plain::whole_below(x.low), high = plain::whole_below(x.high), much = plain::all_lanes(unbounded);
  return through(x, low, high, low == high ? Floats{} : much, low == high ? Floats{} : much);
}

// kernels/math.h's functions. All grow or fall throughout; their rounding is far within the margin that bounds are given at the end.
#define RELUME_MATH_H
static inline real exp_of(const real& x) {
  const Floats high = least(plain::exp_of(x.high), plain::all_lanes(unbounded));
  return through(x, plain::exp_of(x.low), high, high, high);
}
static inline real exp_up_to_89(const real& x) { return exp_of(x); }
static inline real log1p_of(const real& x) {
  const Floats inside = plain::all_lanes(-0.999999f), low = most(x.low, inside), slope = 1.0f / (1.0f + low);
  return through(x, plain::log1p_of(low), plain::log1p_of(most(x.high, inside)), slope, slope * slope);
}
static inline real arc_cosine(const real& x) {
  const Floats most_x = least(magnitude(x), plain::all_lanes(1)), much = plain::all_lanes(unbounded);
  const Floats slope = least(1.0f / plain::square_root((1.0f - most_x) * (1.0f + most_x)), much);
  return through(x, plain::arc_cosine(x.high), plain::arc_cosine(x.low), slope, least(most_x * slope * slope * slope, much));
}

static inline integer operator+(const integer& a, const integer& b) {
  integer y;
  y.low = a.low + b.low, y.high = a.high + b.high, y.constant = a.constant && b.constant;
  return y;
}
static inline integer to_integer(const real& x) {
  integer y;
  y.low = plain::to_integer(x.low), y.high = plain::to_integer(x.high), y.constant = x.constant;
  return y;
}
/// All that lies between the two entries.
static inline real gather(const float* table, const integer& index) {
  real y;
  for (int lane = 0; lane < RELUME_LANES; ++lane) {
    float low = table[index.low[lane]], high = low;
    for (int at = index.low[lane] + 1; at <= index.high[lane]; ++at)
      low = table[at] < low ? table[at] : low, high = table[at] > high ? table[at] : high;
    y.low[lane] = low, y.high[lane] = high;
  }
  return index.constant ? y : rough(y.low, y.high);
}
static inline real all_lanes(float x) { return x; }
/// Whether the condition may hold anywhere.
static inline int any_of(const mask& m) { return plain::any_of(~m.no); }
static inline real load(const float*) { return 0.0f; }
static inline void store(const real&, float*) {}
static inline void store_past_cache(const real&, float*) {}
