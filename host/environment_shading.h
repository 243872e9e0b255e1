// Environments that the device evaluates for itself: their tables, the programs that read them, and what a band brings for them.
#pragma once

#include <vector>

#include "gbuffer/gbuffer.h"
#include "host/device.h"
#include "host/device_environment.h"
#include "host/environment_options.h"

namespace relume {

/// What evaluates them; nothing where there are none.
std::vector<Entry> programs_for(const std::vector<DeviceEnvironment>& environments, const EnvironmentOptions& options);

/// Samples that `options` give a pixel: a multiple of 16, so that eighths of them are even numbers.
int samples_of(const EnvironmentOptions& options);

/// What the device looks up for a pixel and an environment.
int directions_of(const EnvironmentOptions& options);

class EnvironmentShading {
 public:
  /// `tables`: what other programs read, which comes first.
  EnvironmentShading(const std::vector<DeviceEnvironment>& environments, const EnvironmentOptions& options, const std::vector<float>& tables);

  const std::vector<float>& tables() const { return tables_; }
  /// Whether samples estimate them, which leaves an error.
  bool estimates() const { return !records_.empty() && program_ == Entry::environment_sampled; }
  int spare_planes() const { return estimates() ? 2 : 0; }

  /// Fills spare planes with what moves each pixel's samples; the first of them, for Frame::environment.
  int scramble(GBuffer& gbuffer) const;
  /// Adds one environment's light.
  void add(Band& band, const Choice& choice, Frame frame, int environment, const Progress& progress) const;

 private:
  Entry program_ = Entry::environment_sampled;
  std::vector<EnvironmentRecord> records_;
  std::vector<float> tables_;
  int nodes_ = 0, node_count_ = 0;  ///< a coarse quadrature of the lobes' albedo, for what is prefiltered: its own error is larger than that
};

}  // namespace relume
