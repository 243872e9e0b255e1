// A BRDF with free parameters, for fits: many sets of parameters are evaluated in one launch of the kernels that shade frames.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/binding.h"
#include "host/cosines.h"
#include "host/device.h"
#include "lab/fit_samples.h"

namespace relume {

/// A parameter that a fit finds, in an unbounded coordinate u: (sin u + 1)/2 goes through its range (James and Roos 1975, MINUIT), by decades where
/// the range spans several.
struct FreeParameter {
  const Parameter* parameter;
  std::string name;  ///< as users write it
  int first;         ///< where its coordinates begin in a set: one for each component

  double value_at(double u) const;
  double coordinate_of(double value) const;
};

class FitModel {
 public:
  /// `brdf` as for material_named; its free parameters are its lobes' numbers and colours, and f0 of a Fresnel term that has it. Error{input} where
  /// there is none, or where the lobe's tables are made for constants.
  FitModel(const std::string& brdf, std::span<const FitSample> samples, std::shared_ptr<Device> device);

  const std::vector<FreeParameter>& free() const { return free_; }
  int coordinates() const { return coordinates_; }

  /// f_r n.l of every sample (columns: the channels, one after another), a row for each set of coordinates.
  std::vector<Eigen::VectorXd> reflectance(const std::vector<Eigen::VectorXd>& sets);

 private:
  void choose_free_parameters();

  std::string brdf_;
  Material material_;
  std::vector<PreciseCosines> cosines_;
  std::shared_ptr<Device> device_;
  std::vector<FreeParameter> free_;
  int coordinates_ = 0;
  std::optional<Binding> binding_;
};

}  // namespace relume
