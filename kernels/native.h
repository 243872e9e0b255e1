// C++'s spelling of the lanes of language.h, through the vector extensions of g++ and clang. Included once for each namespace
// (relume::lanes1, relume::lanes16, ...) by host/twin_lanes.h, inside that namespace; it needs <cstring> and <cstddef>
// before it. Built-ins rather than std:: functions: an inline function compiled here for AVX-512 must not be the one the linker keeps for everybody.
#define RELUME_FN [[maybe_unused]] static inline
#define RELUME_GLOBAL
#define RELUME_LIGHT

#if RELUME_LANES == 1
typedef float real;
typedef int integer;
#else
typedef float real __attribute__((vector_size(RELUME_LANES * sizeof(float)), aligned(sizeof(float))));
typedef int integer __attribute__((vector_size(RELUME_LANES * sizeof(int)), aligned(sizeof(int))));
#endif
typedef integer mask;

RELUME_FN real choose(mask m, real a, real b) { return m ? a : b; }
RELUME_FN integer choose_integer(mask m, integer a, integer b) { return m ? a : b; }
RELUME_FN real as_real(integer x) { return __builtin_bit_cast(real, x); }
RELUME_FN integer as_integer(real x) { return __builtin_bit_cast(integer, x); }
RELUME_FN real load(const float* p) {
  real x;
  __builtin_memcpy(&x, p, sizeof x);
  return x;
}
RELUME_FN void fetch_soon(const float* p) { __builtin_prefetch(p); }
RELUME_FN void store(real x, float* p) { __builtin_memcpy(p, &x, sizeof x); }
RELUME_FN void store_past_cache(real x, float* p) { store(x, p); }

#if RELUME_LANES == 1
RELUME_FN real all_lanes(float x) { return x; }
RELUME_FN real square_root(real x) { return __builtin_sqrtf(x); }
RELUME_FN real fused(real a, real b, real c) { return __builtin_fmaf(a, b, c); }
RELUME_FN real whole_below(real x) { return __builtin_floorf(x); }
RELUME_FN real absolute(real x) { return __builtin_fabsf(x); }
RELUME_FN real to_real(integer x) { return static_cast<float>(x); }
RELUME_FN integer to_integer(real x) { return static_cast<int>(x); }
RELUME_FN int joined(integer m) { return m; }
RELUME_FN int any_of(mask m) { return m; }
RELUME_FN float least_of(real x) { return x; }
RELUME_FN real gather(const float* table, integer index) { return table[index]; }
#else
RELUME_FN real all_lanes(float x) { return real{} + x; }
RELUME_FN real square_root(real x) {
  for (int lane = 0; lane < RELUME_LANES; ++lane) x[lane] = __builtin_sqrtf(x[lane]);
  return x;
}
RELUME_FN real fused(real a, real b, real c) {
  for (int lane = 0; lane < RELUME_LANES; ++lane) a[lane] = __builtin_fmaf(a[lane], b[lane], c[lane]);
  return a;
}
RELUME_FN real whole_below(real x) {
  for (int lane = 0; lane < RELUME_LANES; ++lane) x[lane] = __builtin_floorf(x[lane]);
  return x;
}
RELUME_FN real absolute(real x) { return as_real(as_integer(x) & 0x7fffffff); }
RELUME_FN real to_real(integer x) { return __builtin_convertvector(x, real); }
RELUME_FN integer to_integer(real x) { return __builtin_convertvector(x, integer); }
// Over all lanes by halves, each a vector of its own.
RELUME_FN int joined(integer m) {
#if RELUME_LANES == 16
  const auto eight = __builtin_shufflevector(m, m, 0, 1, 2, 3, 4, 5, 6, 7) | __builtin_shufflevector(m, m, 8, 9, 10, 11, 12, 13, 14, 15);
#else
  const auto eight = m;
#endif
#if RELUME_LANES >= 8
  const auto four = __builtin_shufflevector(eight, eight, 0, 1, 2, 3) | __builtin_shufflevector(eight, eight, 4, 5, 6, 7);
#else
  const auto four = eight;
#endif
  const auto two = four | __builtin_shufflevector(four, four, 2, 3, 0, 1);
  return two[0] | two[1];
}
RELUME_FN int any_of(mask m) { return joined(m) != 0; }
#define RELUME_LEAST(a, b) ((b) < (a) ? (b) : (a))
RELUME_FN float least_of(real x) {
#if RELUME_LANES == 16
  auto eight = RELUME_LEAST(__builtin_shufflevector(x, x, 0, 1, 2, 3, 4, 5, 6, 7), __builtin_shufflevector(x, x, 8, 9, 10, 11, 12, 13, 14, 15));
#else
  auto eight = x;
#endif
#if RELUME_LANES >= 8
  auto four = RELUME_LEAST(__builtin_shufflevector(eight, eight, 0, 1, 2, 3), __builtin_shufflevector(eight, eight, 4, 5, 6, 7));
#else
  auto four = eight;
#endif
  auto two = RELUME_LEAST(four, __builtin_shufflevector(four, four, 2, 3, 0, 1));
  return RELUME_LEAST(two[0], two[1]);
}
#undef RELUME_LEAST
RELUME_FN real gather(const float* table, integer index) {
  real x;
  for (int lane = 0; lane < RELUME_LANES; ++lane) x[lane] = table[index[lane]];
  return x;
}
#endif
