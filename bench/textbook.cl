// The yardstick: how textbooks write it. One pixel a work-item, unit half vector, built-in exp and, with -DPOW, pow for the powers.
// Cook-Torrance as in Cook and Torrance 1982 (Beckmann, V-groove, Schlick), GGX as in Walter et al. 2007 with height-correlated Smith (Heitz 2014),
// both over Lambert. Planes: position, normal, albedo (three each), alpha; `stride` floats apart.
#ifdef POW
#define POWER2(x) pow(x, 2.0f)
#define POWER4(x) pow(x, 4.0f)
#define POWER5(x) pow(x, 5.0f)
#else
#define POWER2(x) ((x) * (x))
#define POWER4(x) ((x) * (x) * (x) * (x))
#define POWER5(x) ((x) * (x) * (x) * (x) * (x))
#endif
#define PI 3.14159265f

typedef struct {
  float n_h, n_v, n_l, v_h, alpha;
} Angles;

float specular_cook_torrance(Angles a) {
  const float cos2 = POWER2(a.n_h);
  const float d = exp(-(1.0f - cos2) / (cos2 * POWER2(a.alpha))) / (PI * POWER2(a.alpha) * POWER4(a.n_h));
  const float g = min(1.0f, min(2.0f * a.n_h * a.n_v / a.v_h, 2.0f * a.n_h * a.n_l / a.v_h));
  const float f = 0.04f + 0.96f * POWER5(1.0f - a.v_h);
  return d * g * f / (4.0f * a.n_l * a.n_v);
}

float specular_ggx(Angles a) {
  const float alpha2 = POWER2(a.alpha);
  const float d = alpha2 / (PI * POWER2(POWER2(a.n_h) * (alpha2 - 1.0f) + 1.0f));
  const float smith_l = a.n_v * sqrt(POWER2(a.n_l) * (1.0f - alpha2) + alpha2);
  const float smith_v = a.n_l * sqrt(POWER2(a.n_v) * (1.0f - alpha2) + alpha2);
  const float f = 0.04f + 0.96f * POWER5(1.0f - a.v_h);
  return d * f * 0.5f / (smith_l + smith_v);
}

float specular_none(Angles a) { return 0.0f; }

float3 at(__global const float* p, int stride, int i) { return (float3)(p[i], p[i + stride], p[i + 2 * stride]); }

__kernel void shade(__global const float* restrict position, __global const float* restrict normal, __global const float* restrict albedo,
                    __global const float* restrict alpha, int stride, __global const float* restrict lights, int light_count, float3 eye,
                    __global float* restrict out) {
  const int i = get_global_id(0);
  const float3 p = at(position, stride, i), n = at(normal, stride, i), diffuse = at(albedo, stride, i) / PI, v = normalize(eye - p);
  float3 sum = (float3)(0.0f);
  for (int k = 0; k < light_count; ++k) {
    const float3 to_light = (float3)(lights[6 * k], lights[6 * k + 1], lights[6 * k + 2]) - p;
    const float3 intensity = (float3)(lights[6 * k + 3], lights[6 * k + 4], lights[6 * k + 5]);
    const float3 l = normalize(to_light), h = normalize(l + v);
    const Angles a = {max(dot(n, h), 0.0f), dot(n, v), dot(n, l), max(dot(v, h), 0.0f), alpha[i]};
    if (a.n_l > 0.0f && a.n_v > 0.0f) sum += intensity / dot(to_light, to_light) * (diffuse + SPECULAR(a)) * a.n_l;
  }
  out[i] = sum.x;
  out[i + stride] = sum.y;
  out[i + 2 * stride] = sum.z;
}
