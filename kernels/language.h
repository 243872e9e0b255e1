// The one file that knows that two languages read this folder: OpenCL C 1.2 and C++20.
//
// Kernels are written once over lanes: `real` is RELUME_LANES floats side by side (1, 4, 8 or 16), `real3` a struct of three reals, `integer`
// as many ints, `mask` what a comparison of reals gives. The contract that makes PoCL and C++ agree to the last bit:
//   1. exact operations only: + - * / comparisons, square_root, whole_below, and fused (a b + c rounded once), where it is written; no dot,
//      normalize, exp, pow, native_*: our own are in vector.h and math.h, spelt out so that both compilers round alike;
//   2. contraction is off in both (the pragma below, unless --precision relaxed; -ffp-contract=off for the library);
//   3. what crosses to the host is int and float in the structs of frame.h, never a vector type;
//   4. choice is by `choose`, not by branches, wherever lanes may differ.
#ifndef RELUME_LANGUAGE_H
#define RELUME_LANGUAGE_H

#ifndef RELUME_LANES
#error "define RELUME_LANES as 1, 4, 8 or 16 before including a kernel"
#endif

#ifdef RELUME_OPENCL
#ifdef RELUME_RELAXED
#pragma OPENCL FP_CONTRACT ON
#else
#pragma OPENCL FP_CONTRACT OFF
#endif

#if RELUME_LANES == 1
#define RELUME_FN static inline
#else
#define RELUME_FN static inline __attribute__((always_inline))  // PoCL else calls what is used twice, and passes structs of vectors through memory
#endif
#define RELUME_GLOBAL __global
#ifdef RELUME_STAGED
#define RELUME_LIGHT __local  // where the light records lie that kernels read: kernels/staged_lights.h
#else
#define RELUME_LIGHT __global
#endif

#if RELUME_LANES == 1
typedef float real;
typedef int integer;
#define RELUME_AS_REAL(x) as_float(x)
#define RELUME_AS_INTEGER(x) as_int(x)
#define RELUME_TO_REAL(x) convert_float(x)
#define RELUME_TO_INTEGER(x) convert_int(x)
#define RELUME_LOAD(p) (*(p))
#define RELUME_STORE(x, p) (*(p) = (x))
#else
#define RELUME_JOIN_(a, b) a##b
#define RELUME_JOIN(a, b) RELUME_JOIN_(a, b)
typedef RELUME_JOIN(float, RELUME_LANES) real;
typedef RELUME_JOIN(int, RELUME_LANES) integer;
#define RELUME_AS_REAL(x) RELUME_JOIN(as_float, RELUME_LANES)(x)
#define RELUME_AS_INTEGER(x) RELUME_JOIN(as_int, RELUME_LANES)(x)
#define RELUME_TO_REAL(x) RELUME_JOIN(convert_float, RELUME_LANES)(x)
#define RELUME_TO_INTEGER(x) RELUME_JOIN(convert_int, RELUME_LANES)(x)
#define RELUME_LOAD(p) RELUME_JOIN(vload, RELUME_LANES)(0, p)
#define RELUME_STORE(x, p) RELUME_JOIN(vstore, RELUME_LANES)(x, 0, p)
#endif
typedef integer mask;  // 1 or 0 in one lane, -1 or 0 in several: combine with & | !, test with any_of, use with choose

/// `a` where the mask holds, else `b`.
RELUME_FN real choose(mask m, real a, real b) { return select(b, a, m); }
RELUME_FN integer choose_integer(mask m, integer a, integer b) { return select(b, a, m); }
/// a b + c, rounded once.
RELUME_FN real fused(real a, real b, real c) { return fma(a, b, c); }
RELUME_FN real square_root(real x) { return sqrt(x); }
RELUME_FN real whole_below(real x) { return floor(x); }
RELUME_FN real absolute(real x) { return fabs(x); }
RELUME_FN real as_real(integer x) { return RELUME_AS_REAL(x); }
RELUME_FN integer as_integer(real x) { return RELUME_AS_INTEGER(x); }
RELUME_FN real to_real(integer x) { return RELUME_TO_REAL(x); }
/// Towards zero; the caller keeps x within int's range.
RELUME_FN integer to_integer(real x) { return RELUME_TO_INTEGER(x); }
RELUME_FN real all_lanes(float x) { return (real)(x); }
RELUME_FN real load(RELUME_GLOBAL const float* p) { return RELUME_LOAD(p); }
RELUME_FN void store(real x, RELUME_GLOBAL float* p) { RELUME_STORE(x, p); }
/// Of all lanes.
RELUME_FN float least_of(real x) {
#if RELUME_LANES == 16
  const float8 eight = min(x.lo, x.hi);
  const float4 four = min(eight.lo, eight.hi);
#elif RELUME_LANES == 8
  const float4 four = min(x.lo, x.hi);
#elif RELUME_LANES == 4
  const float4 four = x;
#endif
#if RELUME_LANES == 1
  return x;
#else
  const float2 two = min(four.lo, four.hi);
  return min(two.x, two.y);
#endif
}
// Clang's built-in functions make one instruction of what OpenCL C has no word for; most drivers are made of clang.
#ifdef __has_builtin
#if __has_builtin(__builtin_reduce_or)
#define RELUME_REDUCES
#endif
#if __has_builtin(__builtin_nontemporal_store)
#define RELUME_STORES_PAST_CACHE
#endif
#endif
/// A hint: what lies at p is read soon.
RELUME_FN void fetch_soon(RELUME_GLOBAL const float* p) { prefetch(p, 1); }
/// The same as store(), of what is not read again soon: without a cache line that is fetched to be overwritten.
RELUME_FN void store_past_cache(real x, RELUME_GLOBAL float* p) {
#if defined(RELUME_STORES_PAST_CACHE) && RELUME_LANES > 1
  __builtin_nontemporal_store(x, (RELUME_GLOBAL real*)p);
#else
  store(x, p);
#endif
}
/// 1 where the mask holds in any lane, else 0. Never by any(), which PoCL turns into a branch for each lane.
RELUME_FN int any_of(mask m) {
#if RELUME_LANES == 1
  return m;
#elif defined(RELUME_REDUCES)
  return __builtin_reduce_or(m) != 0;
#else
#if RELUME_LANES == 16
  const int8 eight = m.lo | m.hi;
  const int4 four = eight.lo | eight.hi;
#elif RELUME_LANES == 8
  const int4 four = m.lo | m.hi;
#else
  const int4 four = m;
#endif
  const int2 two = four.lo | four.hi;
  return (two.x | two.y) != 0;
#endif
}
/// table[index], lane by lane; from a list of loads, as an array in between would cost a detour through memory.
RELUME_FN real gather(RELUME_GLOBAL const float* table, integer index) {
#define RELUME_FOUR_OF(a, b, c, d) table[index.s##a], table[index.s##b], table[index.s##c], table[index.s##d]
#if RELUME_LANES == 1
  return table[index];
#elif RELUME_LANES == 4
  return (real)(RELUME_FOUR_OF(0, 1, 2, 3));
#elif RELUME_LANES == 8
  return (real)(RELUME_FOUR_OF(0, 1, 2, 3), RELUME_FOUR_OF(4, 5, 6, 7));
#else
  return (real)(RELUME_FOUR_OF(0, 1, 2, 3), RELUME_FOUR_OF(4, 5, 6, 7), RELUME_FOUR_OF(8, 9, a, b), RELUME_FOUR_OF(c, d, e, f));
#endif
}

#else  // C++
#include "kernels/native.h"
#endif

#endif
