// What a device can do at best: arithmetic without memory, memory without arithmetic, and nothing at all.
// LANES: floats in a vector. CHUNK: vectors that a work-item of the memory kernels takes. CONTIGUOUS: 1 where they lie side by side (CPUs: a core
// walks through memory), 0 where neighbours in a group take neighbours in memory (GPUs).
#define JOIN_(a, b) a##b
#define JOIN(a, b) JOIN_(a, b)
#if LANES == 1
typedef float vector;
#define LOAD(i, p) ((p)[i])
#define STORE(x, i, p) ((p)[i] = (x))
#else
typedef JOIN(float, LANES) vector;
#define LOAD(i, p) JOIN(vload, LANES)(i, p)
#define STORE(x, i, p) JOIN(vstore, LANES)(x, i, p)
#endif

// 12 chains that do not wait for each other: two units of latency 4 need 8, and 12 with factor and addend still fit 16 registers.
#define CHAINS(DO) DO(0) DO(1) DO(2) DO(3) DO(4) DO(5) DO(6) DO(7) DO(8) DO(9) DO(10) DO(11)
#define BEGIN(k) vector x##k = (vector)(start + k);
#define STEP(k) x##k = x##k * factor + addend;
#define SUM(k) sum += x##k;

#define CHAIN_KERNEL(name)                                                                              \
  __kernel void name(__global float* out, float start, float factor_given, float addend_given, int n) { \
    const vector factor = (vector)(factor_given), addend = (vector)(addend_given);                      \
    CHAINS(BEGIN)                                                                                       \
    for (int i = 0; i < n; ++i) {                                                                       \
      CHAINS(STEP)                                                                                      \
    }                                                                                                   \
    vector sum = (vector)(0.0f);                                                                        \
    CHAINS(SUM)                                                                                         \
    STORE(sum, get_global_id(0), out);                                                                  \
  }

#pragma OPENCL FP_CONTRACT ON
CHAIN_KERNEL(fused)  // multiply-add in one instruction, where the device has it
#pragma OPENCL FP_CONTRACT OFF
CHAIN_KERNEL(separate)  // multiply, round, add, round: what kernels do that give the same bits everywhere

#if CONTIGUOUS
#define FOR_CHUNK(i) for (size_t i = get_global_id(0) * CHUNK, end = i + CHUNK; i < end; ++i)
#else
#define FOR_CHUNK(i) for (size_t i = get_global_id(0), end = get_global_size(0) * CHUNK; i < end; i += get_global_size(0))
#endif

__kernel void read(__global const float* restrict a, __global const float* restrict b, __global float* restrict c) {
  vector sum = (vector)(0.0f);
  FOR_CHUNK(i) sum += LOAD(i, a);
  STORE(sum, get_global_id(0), c);
}

__kernel void copy(__global const float* restrict a, __global const float* restrict b, __global float* restrict c) {
  FOR_CHUNK(i) STORE(LOAD(i, a), i, c);
}

__kernel void triad(__global const float* restrict a, __global const float* restrict b, __global float* restrict c) {
  FOR_CHUNK(i) STORE(LOAD(i, a) + 3.0f * LOAD(i, b), i, c);
}

__kernel void nothing(__global const float* restrict a, __global const float* restrict b, __global float* restrict c) {}
