// Every subcommand, once: a file cli/<name>.cpp with add_<name>, and its line here.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace relume {

/// What a parsed subcommand runs; its value is the exit code.
using Action = std::function<int()>;

#define RELUME_COMMANDS(COMMAND)                                                       \
  COMMAND(shade, "relight a G-buffer: new lights in, a scene-linear image out")        \
  COMMAND(bake, "a mesh and a camera to a G-buffer that can be relit")                 \
  COMMAND(inspect, "what each channel of a G-buffer means, and how that was told")     \
  COMMAND(doctor, "what is wrong with a G-buffer, where, and what mends it")           \
  COMMAND(compare, "how far two images are apart, layer by layer")                     \
  COMMAND(devices, "OpenCL devices, their lanes and self-test")                        \
  COMMAND(list, "BRDFs, lights and conventions that Relume knows")                     \
  COMMAND(evaluate, "a table of BRDF values for a table of cosines")                   \
  COMMAND(directions, "the directions n, v, l, R_v, R_l, h of every pixel, as layers") \
  COMMAND(plot, "figures of BRDFs: polar plots, maps, lit spheres")                    \
  COMMAND(check_brdf, "whether BRDFs keep the laws that they claim")                   \
  COMMAND(tabulate, "a BRDF as a table in MERL's format")                              \
  COMMAND(fit, "which analytic BRDF comes nearest to a measured table, and with what") \
  COMMAND(figure, "pictures that compare one way of lighting with another")            \
  COMMAND(bench, "how fast devices shade, beside plain C++ and textbook kernels")

#define RELUME_DECLARE_COMMAND(name, summary) void add_##name(CLI::App& command, Action& action);
RELUME_COMMANDS(RELUME_DECLARE_COMMAND)
#undef RELUME_DECLARE_COMMAND

}  // namespace relume
