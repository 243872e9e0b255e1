// EnvironmentShading: tables of all environments one after the other.
#include "host/environment_shading.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cstdint>

#include "host/ambient_nodes.h"
#include "host/prefiltered_environment.h"

namespace relume {
namespace {

constexpr std::int64_t grain = 1 << 14;  // pixels that one task takes: enough to hide the scheduler

}  // namespace

std::vector<Entry> programs_for(const std::vector<DeviceEnvironment>& environments, const EnvironmentOptions& options) {
  if (environments.empty()) return {};
  return {options.method == EnvironmentMethod::sampled ? Entry::environment_sampled : Entry::environment_prefiltered};
}

int samples_of(const EnvironmentOptions& options) { return (options.samples + 15) / 16 * 16; }

int directions_of(const EnvironmentOptions& options) { return options.method == EnvironmentMethod::sampled ? samples_of(options) : 1; }

EnvironmentShading::EnvironmentShading(const std::vector<DeviceEnvironment>& environments, const EnvironmentOptions& options,
                                       const std::vector<float>& tables)
    : tables_(tables) {
  for (const Entry program : programs_for(environments, options)) program_ = program;
  for (const DeviceEnvironment& environment : environments)
    records_.push_back(program_ == Entry::environment_sampled ? place_sampled(environment, samples_of(options), tables_)
                                                              : place_prefiltered(environment, tables_));
  const std::vector<float> nodes = ambient_nodes(8, 6);
  nodes_ = int(tables_.size());
  node_count_ = int(nodes.size() / 4);
  tables_.insert(tables_.end(), nodes.begin(), nodes.end());
}

int EnvironmentShading::scramble(GBuffer& gbuffer) const {
  if (!estimates()) return 0;
  const int first = gbuffer.planes.add(2);
  float *const aside = gbuffer.planes.plane(first), *const along = gbuffer.planes.plane(first + 1);
  const std::int64_t width = gbuffer.window.width(), pixels = gbuffer.window.pixels();
  tbb::parallel_for(tbb::blocked_range<std::int64_t>(0, gbuffer.samples(), grain), [&](const auto& range) {
    for (std::int64_t i = range.begin(); i < range.end(); ++i) {
      const std::int64_t pixel = i < pixels ? i : gbuffer.homes[std::size_t(i - pixels)];
      const int x = int(gbuffer.window.min_x + pixel % width), y = int(gbuffer.window.min_y + pixel / width), surface = i < pixels ? 0 : 1;
      aside[i] = scrambled(x, y, surface, 0);
      along[i] = scrambled(x, y, surface, 1);
    }
  });
  return first;
}

void EnvironmentShading::add(Band& band, const Choice& choice, Frame frame, int environment, const Progress& progress) const {
  const int scramble = frame.environment.scramble;
  frame.environment = records_[std::size_t(environment)];
  frame.environment.scramble = scramble;
  frame.nodes = nodes_;
  frame.node_count = node_count_;
  band.add_environment(program_, choice, frame, progress);
}

}  // namespace relume
