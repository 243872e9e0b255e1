// Analytic BRDFs fitted to a measured table by non-linear least squares, every value of theirs from the kernels.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "lab/fit_samples.h"

namespace relume {

struct FittedParameter {
  std::string name;
  std::vector<double> values;  ///< one, or three
  bool at_bound;               ///< a value has come to the end of its range
};

struct Fit {
  std::string brdf;
  std::vector<FittedParameter> parameters;
  double residual;        ///< root mean square in the metric
  double plain_residual;  ///< root mean square of f_r, 1/sr, every sample alike
  /// PARAM=VALUE, as --set takes it.
  std::vector<std::string> settings() const;
};

/// What is worth fitting: each diffuse lobe alone that is for matt surfaces, and each specular lobe with the diffuse lobe of its own kind.
std::vector<std::string> fitted_by_default();

/// Levenberg and Marquardt's method from three widths of the highlight, the best of them to its end.
Fit fit(const std::string& brdf, const std::vector<FitSample>& samples, FitMetric metric, const std::shared_ptr<Device>& device);

}  // namespace relume
