// Cook and Torrance 1982 (Beckmann, V-groove, Schlick's Fresnel) and GGX (Walter et al. 2007, Smith's height-correlated shadowing of Heitz 2014),
// both over Lambert. Built for this very processor (bench/CMakeLists.txt); g++ vectorises the loop over lights (-fopt-info-vec).
#include "bench/plain_shading.h"

#include <cmath>

namespace relume::bench {
namespace {

constexpr float pi = 3.14159265f;

struct Angles {
  float n_h, n_v, n_l, v_h, alpha;
};

inline float smaller(float a, float b) { return a < b ? a : b; }
inline float larger(float a, float b) { return a > b ? a : b; }

inline float schlick(float v_h) {
  const float m = 1 - v_h;
  return 0.04f + 0.96f * (m * m * m * m * m);
}

struct Lambert {
  static float specular(const Angles&) { return 0; }
};

struct CookTorrance {
  static float specular(const Angles& a) {
    const float cos2 = a.n_h * a.n_h, alpha2 = a.alpha * a.alpha;
    const float d = std::exp(-(1 - cos2) / (cos2 * alpha2)) / (pi * alpha2 * cos2 * cos2);
    const float g = smaller(1, smaller(2 * a.n_h * a.n_v / a.v_h, 2 * a.n_h * a.n_l / a.v_h));
    return d * g * schlick(a.v_h) / (4 * a.n_l * a.n_v);
  }
};

struct Ggx {
  static float specular(const Angles& a) {
    const float alpha2 = a.alpha * a.alpha, t = a.n_h * a.n_h * (alpha2 - 1) + 1;
    const float smith_l = a.n_v * std::sqrt(a.n_l * a.n_l * (1 - alpha2) + alpha2);
    const float smith_v = a.n_l * std::sqrt(a.n_v * a.n_v * (1 - alpha2) + alpha2);
    return alpha2 / (pi * t * t) * schlick(a.v_h) * 0.5f / (smith_l + smith_v);
  }
};

template <class Brdf>
void shade(const PlainPixels& p, const PlainLights& lights, int first, int last) {
  for (int i = first; i < last; ++i) {
    const float px = p.position[0][i], py = p.position[1][i], pz = p.position[2][i];
    const float nx = p.normal[0][i], ny = p.normal[1][i], nz = p.normal[2][i], alpha = p.alpha[i];
    const float kr = p.albedo[0][i] / pi, kg = p.albedo[1][i] / pi, kb = p.albedo[2][i] / pi;
    float vx = p.eye[0] - px, vy = p.eye[1] - py, vz = p.eye[2] - pz;
    const float v_length = std::sqrt(vx * vx + vy * vy + vz * vz);
    vx /= v_length, vy /= v_length, vz /= v_length;
    const float n_v = nx * vx + ny * vy + nz * vz;
    float r = 0, g = 0, b = 0;
#pragma omp simd reduction(+ : r, g, b)
    for (int k = 0; k < lights.count; ++k) {
      float lx = lights.position[0][k] - px, ly = lights.position[1][k] - py, lz = lights.position[2][k] - pz;
      const float d2 = lx * lx + ly * ly + lz * lz, d = std::sqrt(d2);
      lx /= d, ly /= d, lz /= d;
      float hx = lx + vx, hy = ly + vy, hz = lz + vz;
      const float h_length = std::sqrt(hx * hx + hy * hy + hz * hz);
      hx /= h_length, hy /= h_length, hz /= h_length;
      const float n_l = nx * lx + ny * ly + nz * lz;
      const Angles a{larger(nx * hx + ny * hy + nz * hz, 0), n_v, n_l, larger(vx * hx + vy * hy + vz * hz, 0), alpha};
      const float specular = Brdf::specular(a), arriving = n_l > 0 && n_v > 0 ? n_l / d2 : 0;
      r += lights.intensity[0][k] * arriving * (kr + specular);
      g += lights.intensity[1][k] * arriving * (kg + specular);
      b += lights.intensity[2][k] * arriving * (kb + specular);
    }
    p.out[0][i] = r, p.out[1][i] = g, p.out[2][i] = b;
  }
}

}  // namespace

void shade_plainly(PlainBrdf brdf, const PlainPixels& pixels, const PlainLights& lights, int first, int last) {
  if (brdf == PlainBrdf::lambert) shade<Lambert>(pixels, lights, first, last);
  if (brdf == PlainBrdf::cook_torrance) shade<CookTorrance>(pixels, lights, first, last);
  if (brdf == PlainBrdf::ggx) shade<Ggx>(pixels, lights, first, last);
}

}  // namespace relume::bench
