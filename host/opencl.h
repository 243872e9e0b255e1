// OpenCL's C++ bindings with our error: the status in words and the call that gave it.
#pragma once

#include <CL/opencl.hpp>
#include <memory>
#include <string>
#include <vector>

#include "host/device.h"

namespace relume {

/// "CL_OUT_OF_RESOURCES (-5)"
std::string status_name(cl_int status);

/// An OpenCL failure as Error{device}: "pthread-...: clEnqueueNDRangeKernel: CL_OUT_OF_RESOURCES (-5)".
[[noreturn]] void rethrow(const cl::Error& error, const std::string& device);

/// Devices of all platforms, in the order of list_devices().
std::vector<cl::Device> opencl_devices();

DeviceInfo describe(const cl::Device& device);

std::unique_ptr<Device> open_opencl_device(const cl::Device& device, const DeviceInfo& info);

}  // namespace relume
