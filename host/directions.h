// The lecture's important directions as layers: n, v, l, R_v, R_l and h of every pixel for one light, and their cosines, from the device.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gbuffer/reading.h"
#include "gbuffer/write_exr.h"
#include "host/rig.h"

namespace relume {

struct DirectionsJob {
  std::filesystem::path gbuffer, output;
  std::vector<std::filesystem::path> rigs;
  RigOptions rig_options;
  ReadingOptions reading;
  std::string light;  ///< a name in the rigs; empty: their only light; "X,Y,Z": a point in world units, with no rig
  OutputFormat format;
  std::optional<std::filesystem::path> png;  ///< all layers in false colours, side by side
  std::string device;
};

struct DirectionsSummary {
  std::string device, light;
  std::vector<std::string> notes;
};

/// Writes layers n, v, l, R_v, R_l, h (X Y Z, world, unit length) and `cosine.n_l` ... `cosine.R_v_l`; zeros where no surface is shown. Throws Error;
/// the outputs are whole or untouched.
DirectionsSummary write_directions(const DirectionsJob& job);

}  // namespace relume
