// An OpenCL program of the benchmark's own on a device: built from text, run over buffers.
#pragma once

#include <string>
#include <vector>

#include "host/opencl.h"

namespace relume::bench {

/// As a cl::Device, by its position in list_devices(); `threads`: a part of it with so many compute units, 0: the whole.
cl::Device opencl_device(const DeviceInfo& info, int threads = 0);

class OwnProgram {
 public:
  /// Throws Error{device} with the compiler's first line.
  OwnProgram(const DeviceInfo& info, const std::string& text, const std::string& options, int threads = 0);

  cl::Buffer buffer(std::size_t floats);
  /// Copied from the host's memory.
  cl::Buffer buffer(const float* data, std::size_t floats);
  void read(const cl::Buffer& buffer, float* data, std::size_t floats);
  cl::Kernel kernel(const std::string& name);
  /// Waits until it is done. `group` 0: the driver's choice.
  void run(const cl::Kernel& kernel, std::size_t items, std::size_t group = 0);

 private:
  std::string name_;
  cl::Device device_;
  cl::Context context_;
  cl::CommandQueue queue_;
  cl::Program program_;
};

}  // namespace relume::bench
