// fit: residuals and their derivatives for Eigen's Levenberg-Marquardt, which is MINPACK's (Moré 1978).
#include "lab/fit.h"

#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/LevenbergMarquardt>

#include "gbuffer/error.h"
#include "host/lobes.h"
#include "lab/fit_model.h"

namespace relume {
namespace {

using Vector = Eigen::VectorXd;

/// Model minus measurement, so weighted that its norm is the root mean square over samples and channels.
struct Residuals : Eigen::DenseFunctor<double> {
  Residuals(FitModel& fitted, const std::vector<FitSample>& measured, FitMetric in)
      : DenseFunctor(fitted.coordinates(), int(3 * measured.size())), model(fitted), samples(measured), metric(in) {}

  Vector weighted(const Vector& reflectance) const {
    Vector r(reflectance.size());
    for (Eigen::Index k = 0; k < r.size(); ++k) {
      const FitSample& sample = samples[std::size_t(k) % samples.size()];
      const double measured = sample.f[int(std::size_t(k) / samples.size())] * sample.pair.l.z;
      r[k] = std::sqrt(sample.weight / 3) * (compressed(metric, reflectance[k]) - compressed(metric, measured));
    }
    return r;
  }

  int operator()(const Vector& u, Vector& r) const {
    r = weighted(model.reflectance({u}).front());
    return 0;
  }

  /// Central differences, all in one launch. A channel of the BRDF depends on no other channel of its colours: they move together.
  int df(const Vector& u, Eigen::MatrixXd& jacobian) const {
    constexpr double step = 2e-3;  // of u: the kernels' single precision is then 1e-4 of a derivative, and the third derivative less
    std::vector<Vector> sets;
    for (const FreeParameter& p : model.free())
      for (const double sign : {1.0, -1.0}) {
        sets.push_back(u);
        sets.back().segment(p.first, p.parameter->components).array() += sign * step;
      }
    const std::vector<Vector> values = model.reflectance(sets);
    jacobian.setZero(this->values(), inputs());
    const Eigen::Index n = Eigen::Index(samples.size());
    for (std::size_t k = 0; k < model.free().size(); ++k) {
      const FreeParameter& p = model.free()[k];
      const Vector slope = (weighted(values[2 * k]) - weighted(values[2 * k + 1])) / (2 * step);
      if (p.parameter->components == 1) jacobian.col(p.first) = slope;
      for (int c = 0; c < 3 && p.parameter->components == 3; ++c) jacobian.col(p.first + c).segment(c * n, n) = slope.segment(c * n, n);
    }
    return 0;
  }

  FitModel& model;
  const std::vector<FitSample>& samples;
  FitMetric metric;
};

/// At most so many steps from u; the root mean square that is left.
double improve(Residuals& residuals, Vector& u, int steps) {
  Eigen::LevenbergMarquardt<Residuals> solver(residuals);
  if (solver.minimizeInit(u) == Eigen::LevenbergMarquardtSpace::ImproperInputParameters)
    throw Error(ErrorKind::input, "--brdf: the table has fewer measurements than the BRDF has parameters");
  for (int k = 0; k < steps && solver.minimizeOneStep(u) == Eigen::LevenbergMarquardtSpace::Running; ++k) continue;
  return solver.fnorm();
}

/// Highlights narrow, middling and wide, colours dim: a fit falls into the valley that it starts in.
double start_of(const FreeParameter& p, int which) {
  static const std::map<std::string, std::array<double, 3>> widths{
      {"alpha", {0.03, 0.12, 0.45}}, {"roughness", {0.17, 0.35, 0.67}}, {"exponent", {500, 60, 8}}};
  if (const auto width = widths.find(p.name); width != widths.end()) return width->second[std::size_t(which)];
  return p.parameter->lowest + 0.25 * (p.parameter->highest - p.parameter->lowest);
}

Fit result_of(FitModel& model, const std::string& brdf, const std::vector<FitSample>& samples, const Vector& u, double residual) {
  Fit fit{brdf, {}, residual, 0};
  for (const FreeParameter& p : model.free()) {
    FittedParameter found{p.name, {}, false};
    for (int c = 0; c < p.parameter->components; ++c) {
      found.values.push_back(p.value_at(u[p.first + c]));
      const double share = (std::sin(u[p.first + c]) + 1) / 2;
      found.at_bound = found.at_bound || share < 1e-4 || share > 1 - 1e-4;
    }
    fit.parameters.push_back(found);
  }
  const Vector values = model.reflectance({u}).front();
  double sum = 0;
  for (Eigen::Index k = 0; k < values.size(); ++k) {
    const FitSample& sample = samples[std::size_t(k) % samples.size()];
    const double error = values[k] / sample.pair.l.z - sample.f[int(std::size_t(k) / samples.size())];
    sum += error * error;
  }
  fit.plain_residual = std::sqrt(sum / double(values.size()));
  return fit;
}

}  // namespace

std::vector<std::string> Fit::settings() const {
  std::vector<std::string> all;
  for (const FittedParameter& p : parameters) {
    std::string text = p.name + "=";
    for (std::size_t c = 0; c < p.values.size(); ++c) {
      char digits[32];
      std::snprintf(digits, sizeof digits, "%.6g", p.values[c]);
      text += (c ? "," : "") + std::string(digits);
    }
    all.push_back(text);
  }
  return all;
}

std::vector<std::string> fitted_by_default() {
  std::vector<std::string> names{"lambert+none", "oren_nayar+none"};
  for (const Lobe& lobe : specular_lobes()) {
    const std::string name(lobe.name);
    // A table is no formula; Cycles' lobes take their albedo from its passes.
    if (name == "merl" || name.starts_with("cycles")) continue;
    names.push_back((find_lobe(true, name) ? name : name.ends_with("_original") ? "lambert_original" : "lambert") + "+" + name);
  }
  return names;
}

Fit fit(const std::string& brdf, const std::vector<FitSample>& samples, FitMetric metric, const std::shared_ptr<Device>& device) {
  FitModel model(brdf, samples, device);
  Residuals residuals(model, samples, metric);
  Vector best;
  double least = 0;
  for (int which = 0; which < 3; ++which) {
    Vector u(model.coordinates());
    for (const FreeParameter& p : model.free()) u.segment(p.first, p.parameter->components).setConstant(p.coordinate_of(start_of(p, which)));
    const double left = improve(residuals, u, 10);
    if (best.size() == 0 || left < least) {
      best = u;
      least = left;
    }
  }
  least = improve(residuals, best, 100);
  return result_of(model, brdf, samples, best, least);
}

}  // namespace relume
