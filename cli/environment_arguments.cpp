// EnvironmentArguments: the ways from their list.
#include "cli/environment_arguments.h"

#include <algorithm>
#include <vector>

namespace relume {
namespace {

#define RELUME_NAME(name, ...) #name,
const std::vector<std::string> names = {RELUME_ENVIRONMENT_METHODS(RELUME_NAME)};
#undef RELUME_NAME
#define RELUME_MEANING(name, meaning) #name ": " meaning "; "
constexpr const char* meanings = RELUME_ENVIRONMENT_METHODS(RELUME_MEANING) "a note says which way was taken";
#undef RELUME_MEANING

}  // namespace

void EnvironmentArguments::add_to(CLI::App& command) {
  const char* group = "Environment lights";
  method = names[std::size_t(chosen.method)];
  command.add_option("--environment", method, meanings)->check(CLI::IsMember(names))->capture_default_str()->group(group);
  command.add_option("--samples", chosen.samples, "sampled: for each pixel and environment, rounded up to a multiple of 16")
      ->check(CLI::Range(1, 65536))
      ->capture_default_str()
      ->group(group);
  command.add_option("--environment-lights", chosen.lights, "median_cut: directional lights for an environment")
      ->check(CLI::Range(1, 65536))
      ->capture_default_str()
      ->group(group);
}

EnvironmentOptions EnvironmentArguments::options() const {
  EnvironmentOptions options = chosen;
  options.method = EnvironmentMethod(std::find(names.begin(), names.end(), method) - names.begin());
  return options;
}

}  // namespace relume
