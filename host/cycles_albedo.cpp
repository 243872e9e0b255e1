// Measured with Blender 4.5 and 5.0 (research: blender-truth): the pass holds f0 + (1 - f0) ramp, the ramp being read from 16 x 16 (x 16) tables with
// linear interpolation, whose nodes are kept here because their interpolation error is part of the files.
#include "host/cycles_albedo.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "host/ggx_albedo.h"
#include "host/visible_normals.h"
#include "kernels/cycles_tables.h"

namespace relume {

namespace {

constexpr int side = 16;

/// Linear interpolation between two of n evenly spaced nodes.
struct Between {
  int node;
  double t;

  Between(double x, int n) {
    const double at = (x > 0 ? std::min(x, 1.0) : 0) * (n - 1);  // NaN counts as 0
    node = std::min(int(at), n - 2);
    t = at - node;
  }
  double operator()(double low, double high) const { return low + (high - low) * t; }
};

/// How far from f0 to 1 a facet's reflectance has gone: exact Fresnel, and Schlick's with this exponent.
double dielectric_ramp(double f0, double cosine) {
  const double root = std::sqrt(f0), eta = (1 + root) / (1 - root), g = std::sqrt(eta * eta - 1 + cosine * cosine);
  const double a = (g - cosine) / (g + cosine), b = (cosine * (g + cosine) - 1) / (cosine * (g - cosine) + 1);
  return std::clamp((0.5 * a * a * (1 + b * b) - f0) / (1 - f0), 0.0, 1.0);
}
double schlick_ramp(double exponent, double cosine) { return std::pow(1 - cosine, exponent); }

struct Ramps {
  double metal;
  std::array<double, side> dielectric;
};

/// f0 is the fourth power of the third coordinate, at most 0.99 of its range; at f0 = 0 there is no surface to reflect.
double f0_at(int node) { return std::pow(std::min(node / double(side - 1), 0.99), 4); }

/// Cycles reads Schlick's power 5 half way between its nodes, which stand for 40/7 and 35/8.
double metal_ramp(double cosine) { return 0.5 * (schlick_ramp(40.0 / 7.0, cosine) + schlick_ramp(35.0 / 8.0, cosine)); }

Ramps ramps_at(double roughness, double mu) {
  static const Quadrature slices = gauss_legendre(16), along = gauss_legendre(24);
  const auto mean = [&](const auto& ramp) {
    if (roughness == 0) return ramp(mu);
    return mean_over_visible_normals(roughness * roughness, mu, slices, along, [&](double v_m, double) { return ramp(v_m); });
  };
  Ramps ramps{mean(metal_ramp), {}};
  for (int i = 1; i < side; ++i) ramps.dielectric[i] = mean([&](double cosine) { return dielectric_ramp(f0_at(i), cosine); });
  return ramps;
}

struct Tables {
  std::vector<float> albedo = cycles_tables();
  std::vector<Ramps> ramps = std::vector<Ramps>(side * side);  // [n.v][roughness]

  Tables() {
    constexpr double least_cosine = 1e-4;  // Cycles' first node stands for this
    tbb::parallel_for(0, side * side,
                      [&](int i) { ramps[i] = ramps_at(i % side / double(side - 1), std::max(least_cosine, i / side / double(side - 1))); });
  }
};

const Tables& tables() {
  static const Tables tables;
  return tables;
}

}  // namespace

CyclesAlbedo::CyclesAlbedo(double roughness, double n_v, bool multi_ggx) : multi_ggx_(multi_ggx) {
  constexpr int fine = RELUME_CYCLES_TABLE_SIDE;
  const Tables& t = tables();
  const Between x(roughness, fine), y(n_v, fine), u(roughness, side), v(n_v, side);
  const float* e = t.albedo.data() + RELUME_CYCLES_E_START + y.node * fine + x.node;
  const float* mean = t.albedo.data() + RELUME_CYCLES_E_MEAN_START + x.node;
  albedo_ = y(x(e[0], e[1]), x(e[fine], e[fine + 1]));
  mean_albedo_ = x(mean[0], mean[1]);
  const Ramps* r = &t.ramps[v.node * side + u.node];
  metal_ramp_ = v(u(r[0].metal, r[1].metal), u(r[side].metal, r[side + 1].metal));
  for (int i = 0; i < side; ++i) {
    dielectric_ramp_[i] = v(u(r[0].dielectric[i], r[1].dielectric[i]), u(r[side].dielectric[i], r[side + 1].dielectric[i]));
  }
}

double CyclesAlbedo::energy(double mean_fresnel) const {
  if (!multi_ggx_) return 1;  // the pass ignores what a single bounce loses
  return albedo_ + mean_fresnel * mean_albedo_ / (1 - mean_fresnel * (1 - mean_albedo_)) * (1 - albedo_);
}

double CyclesAlbedo::metal(double base) const { return (base + (1 - base) * metal_ramp_) * energy(base + (1 - base) / 21); }

double CyclesAlbedo::dielectric(double f0) const {
  const double root = std::sqrt(f0), eta = (1 + root) / (1 - root);
  const Between z(std::sqrt(root), side);
  const double ramp = z(dielectric_ramp_[z.node], dielectric_ramp_[z.node + 1]);
  return (f0 + (1 - f0) * ramp) * energy(std::max(f0, (eta - 1) / (4.08567 + 1.00071 * eta)));
}

}  // namespace relume
