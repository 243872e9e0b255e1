// The options that say how environment lights are evaluated, for every command that shades.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "host/environment_options.h"

namespace relume {

struct EnvironmentArguments {
  EnvironmentOptions chosen;
  std::string method;

  void add_to(CLI::App& command);
  EnvironmentOptions options() const;
};

}  // namespace relume
