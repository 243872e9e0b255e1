// The public call: a stored G-buffer and a rig in, a relit image out. The command line calls it, and what comes later (a service) will too.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gbuffer/reading.h"
#include "gbuffer/write_exr.h"
#include "host/device.h"
#include "host/environment_options.h"
#include "host/interpolation.h"
#include "host/materials.h"
#include "host/rig.h"

namespace relume {

struct RelightJob {
  std::filesystem::path gbuffer, output;
  std::vector<std::filesystem::path> rigs;
  RigOptions rig_options;
  ReadingOptions reading;                          ///< its `camera` is what --camera named
  EnvironmentOptions environments;                 ///< --environment
  Material material;                               ///< --diffuse, --specular, --set
  std::optional<std::filesystem::path> materials;  ///< a material file
  bool diffuse_layer = false, specular_layer = false, ambient_layer = false, light_layers = false;
  std::optional<Window> crop;  ///< display-window coordinates
  OutputFormat format;
  Interpolation interpolation = Interpolation::phong;  ///< the others need what relume bake stores
  bool mend_edges = true;  ///< pixels that mix surfaces are shaded surface by surface; else the stored means are shaded as they are
  double error = 0;        ///< share of itself that a channel of a pixel may be off by, for speed under many lights; 0: exact
  std::optional<std::filesystem::path> png;
  double exposure = 0;  ///< stops, of the PNG alone
  std::string device;   ///< empty: the best, falling back to the twin with a note
  Precision precision = Precision::exact;
  std::int64_t memory = std::int64_t(2) << 30;  ///< bytes for the planes of all bands in flight
};

struct RelightSummary {
  std::string device, convention;
  Window window;
  std::int64_t surface_pixels = 0, bad_pixels = 0;
  int lights = 0;      ///< of the rig, without ambient ones
  int directions = 0;  ///< what the kernels met for them: as many for an environment as its texels, regions or samples
  int bands = 0;
  std::vector<std::string> programs;
  std::vector<std::pair<std::string, double>> seconds;  ///< stage -> wall clock, in order; from "read" to "write" they overlap
  double pixel_lights_per_second = 0;                   ///< surface pixels times directions over the time of shading
  std::vector<std::string> notes;                       ///< what was assumed, warnings
};

/// What watches a job. progress() may throw to stop it: nothing is left behind. It is called from any thread, but by one at a time.
struct Observer {
  std::function<void(const std::string& stage, double share)> progress;  ///< share of the stage done, 0..1
};

/// Throws Error; the output is whole or untouched.
RelightSummary relight(const RelightJob& job, const Observer& observer);

}  // namespace relume
