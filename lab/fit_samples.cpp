// fit_samples: theta_h in full, as highlights are narrow there; theta_d and phi_d thinned, along which BRDFs are smooth.
#include "lab/fit_samples.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gbuffer/error.h"
#include "lab/tabulate.h"

namespace relume {
namespace {

constexpr int most_theta_h = 180, theta_d_taken = 15, phi_d_taken = 6;

/// About `wanted` of `count` bins, evenly spread, from the middle of the first step.
std::vector<int> spread(int count, int wanted) {
  const int taken = std::min(count, wanted);
  std::vector<int> bins;
  for (int i = 0; i < taken; ++i) bins.push_back(int((i + 0.5) * count / taken));
  return bins;
}

/// d omega_l d omega_v of a bin, but for a factor: sin theta_h dtheta_h on the one hand, 4 cos theta_d sin theta_d dtheta_d on the other; theta_h's
/// bins grow with the root of theta_h.
double solid_angles(const MerlAngles& a) { return std::sin(a.theta_h) * std::sqrt(a.theta_h) * std::sin(a.theta_d) * std::cos(a.theta_d); }

/// The mean of an entry and its mirror image, which lookups give; below 0 in a channel where either is not measured.
glm::dvec3 value_of(const MerlTable& table, int h, int d, int phi) {
  glm::dvec3 f;
  for (int c = 0; c < 3; ++c) {
    const std::vector<float>& plane = table.f[std::size_t(c)];
    const double a = plane[table.at(h, d, phi)], b = plane[table.at(h, d, table.phi_d - 1 - phi)];
    f[c] = std::min(a, b) < 0 ? -1 : (a + b) / 2;
  }
  return f;
}

}  // namespace

FitMetric fit_metric_named(const std::string& name) {
#define RELUME_NAMED(metric, meaning) \
  if (name == #metric) return FitMetric::metric;
  RELUME_FIT_METRICS(RELUME_NAMED)
#undef RELUME_NAMED
  throw Error(ErrorKind::input, "--metric: must be log, cube_root or cosine");
}

const char* name_of(FitMetric metric) {
#define RELUME_NAME(name, meaning) #name,
  static constexpr const char* names[] = {RELUME_FIT_METRICS(RELUME_NAME)};
#undef RELUME_NAME
  return names[int(metric)];
}

double compressed(FitMetric metric, double reflectance) {
  if (metric == FitMetric::log) return std::log1p(reflectance);
  return metric == FitMetric::cube_root ? std::cbrt(reflectance) : reflectance;
}

std::vector<FitSample> fit_samples(const MerlTable& table, FitMetric metric, double grazing, const std::string& place) {
  const double least = std::cos(grazing * std::numbers::pi / 180);
  std::vector<FitSample> samples;
  double sum = 0;
  for (const int h : spread(table.theta_h, most_theta_h))
    for (const int d : spread(table.theta_d, theta_d_taken))
      for (const int phi : spread(table.phi_d / 2, phi_d_taken)) {
        const MerlAngles angles = angles_of(table, h, d, phi);
        const DirectionPair pair = directions_of(angles);
        const glm::dvec3 f = value_of(table, h, d, phi);
        if (pair.l.z < least || pair.v.z < least || std::min({f.x, f.y, f.z}) < 0) continue;
        samples.push_back({pair, f, metric == FitMetric::cosine ? solid_angles(angles) : 1.0});
        sum += samples.back().weight;
      }
  if (samples.empty()) throw Error(ErrorKind::input, place + ": nothing is measured in all channels within the angles asked for (--grazing)");
  for (FitSample& sample : samples) sample.weight /= sum;
  return samples;
}

}  // namespace relume
