// From the embedded kernel files to a built program: joined into one text, built for one choice of lobes, its binary kept for the next run.
#pragma once

#include <CL/opencl.hpp>
#include <string>

#include "host/device.h"

namespace relume {

/// `file` with every #include of a kernel file replaced by that file, once each, between #line marks, so that a compiler's message names the real
/// place. Of the lobes only those of `choice` are taken: a program with all of them takes three times as long to build.
std::string joined_text(const std::string& file, const Choice& choice);

/// The options that make a program of `choice`.
std::string build_options(const DeviceInfo& device, const Choice& choice);

/// Builds "kernels/<entry>.cl", or takes its binary from the cache. Throws Error{device} with the first line of the build log.
cl::Program build_program(const cl::Context& context, const cl::Device& device, const DeviceInfo& info, const std::string& entry,
                          const Choice& choice);

}  // namespace relume
