// The options that say what could not be found out about a file, shared by the commands that read one.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "gbuffer/reading.h"

namespace relume {

struct ReadingArguments {
  std::string convention, view_layer, view, camera;
  int part = -1;
  std::vector<std::string> map;
  std::string normal_space, position_space, normal_encoding, normal_axes, position_axes, depth_kind, premultiplied, facing, bump_shadowing;
  double position_scale = 0;

  void add_to(CLI::App& command);
  /// Throws Error{input}.
  ReadingOptions options() const;
};

/// The camera that --camera names: of a rig, a glTF or another EXR's header; "auto" recovers it from the positions.
Camera camera_from(const std::string& file);

}  // namespace relume
