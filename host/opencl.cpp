// Platforms, devices and the words for OpenCL's status codes.
#include "host/opencl.h"

#include <algorithm>
#include <array>
#include <utility>

#include "gbuffer/error.h"
#include "gbuffer/watched.h"
#include "host/driver_environment.h"

namespace relume {
namespace {

constexpr std::array statuses{
    std::pair{-1, "CL_DEVICE_NOT_FOUND"},
    std::pair{-2, "CL_DEVICE_NOT_AVAILABLE"},
    std::pair{-3, "CL_COMPILER_NOT_AVAILABLE"},
    std::pair{-4, "CL_MEM_OBJECT_ALLOCATION_FAILURE"},
    std::pair{-5, "CL_OUT_OF_RESOURCES"},
    std::pair{-6, "CL_OUT_OF_HOST_MEMORY"},
    std::pair{-11, "CL_BUILD_PROGRAM_FAILURE"},
    std::pair{-30, "CL_INVALID_VALUE"},
    std::pair{-36, "CL_INVALID_COMMAND_QUEUE"},
    std::pair{-37, "CL_INVALID_HOST_PTR"},
    std::pair{-38, "CL_INVALID_MEM_OBJECT"},
    std::pair{-42, "CL_INVALID_BINARY"},
    std::pair{-43, "CL_INVALID_BUILD_OPTIONS"},
    std::pair{-44, "CL_INVALID_PROGRAM"},
    std::pair{-45, "CL_INVALID_PROGRAM_EXECUTABLE"},
    std::pair{-46, "CL_INVALID_KERNEL_NAME"},
    std::pair{-48, "CL_INVALID_KERNEL"},
    std::pair{-52, "CL_INVALID_KERNEL_ARGS"},
    std::pair{-54, "CL_INVALID_WORK_GROUP_SIZE"},
    std::pair{-61, "CL_INVALID_BUFFER_SIZE"},
    std::pair{-1001, "CL_PLATFORM_NOT_FOUND_KHR"},
};

std::string trimmed(std::string text) {
  while (!text.empty() && (text.back() == '\0' || text.back() == ' ')) text.pop_back();
  return text;
}

/// An explicit vector on a CPU, one pixel a work-item on a GPU: measured 4x on PoCL, which does not vectorise across a light loop.
int lanes_of(const cl::Device& device, bool is_cpu) {
  if (!is_cpu) return 1;
  const cl_uint width = device.getInfo<CL_DEVICE_NATIVE_VECTOR_WIDTH_FLOAT>();
  return width >= 16 ? 16 : width >= 8 ? 8 : width >= 4 ? 4 : 1;
}

}  // namespace

std::string status_name(cl_int status) {
  const auto found = std::find_if(statuses.begin(), statuses.end(), [&](const auto& s) { return s.first == status; });
  return (found == statuses.end() ? "OpenCL status" : found->second) + (" (" + std::to_string(status) + ")");
}

void rethrow(const cl::Error& error, const std::string& device) {
  throw Error(ErrorKind::device, device + ": " + error.what() + ": " + status_name(error.err()));
}

std::vector<cl::Device> opencl_devices() {
  if (drivers_are_distrusted())
    throw Error(ErrorKind::device, "the OpenCL driver crashed, and again with nothing compiled before (--device twin needs none)");
  const InForeignCode driver(Foreign::driver);
  prepare_driver_environment();
  std::vector<cl::Device> all;
  std::vector<cl::Platform> platforms;
  try {
    cl::Platform::get(&platforms);
  } catch (const cl::Error&) {
    return all;  // no loader, no ICD: no devices, not an error
  }
  for (const cl::Platform& platform : platforms) {
    try {
      std::vector<cl::Device> devices;
      platform.getDevices(CL_DEVICE_TYPE_ALL, &devices);
      for (const cl::Device& device : devices)
        if (device.getInfo<CL_DEVICE_AVAILABLE>() && device.getInfo<CL_DEVICE_COMPILER_AVAILABLE>()) all.push_back(device);
    } catch (const cl::Error&) {
      continue;  // Mesa's platforms report CL_DEVICE_NOT_FOUND where they have none
    }
  }
  return all;
}

DeviceInfo describe(const cl::Device& device) {
  DeviceInfo info;
  const cl_device_type type = device.getInfo<CL_DEVICE_TYPE>();
  info.name = trimmed(device.getInfo<CL_DEVICE_NAME>());
  info.platform = trimmed(cl::Platform(device.getInfo<CL_DEVICE_PLATFORM>()).getInfo<CL_PLATFORM_NAME>());
  info.vendor = trimmed(device.getInfo<CL_DEVICE_VENDOR>());
  info.version = trimmed(device.getInfo<CL_DEVICE_VERSION>());
  info.driver = trimmed(device.getInfo<CL_DRIVER_VERSION>());
  info.is_cpu = type & CL_DEVICE_TYPE_CPU;
  info.is_gpu = type & CL_DEVICE_TYPE_GPU;
  info.lanes = lanes_of(device, info.is_cpu);
  info.correctly_rounded = device.getInfo<CL_DEVICE_SINGLE_FP_CONFIG>() & CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT;
  info.memory = device.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>();
  info.max_allocation = device.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>();
  return info;
}

}  // namespace relume
