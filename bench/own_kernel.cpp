// OwnProgram: each call into the driver turned into our errors.
#include "bench/own_kernel.h"

#include "gbuffer/error.h"
#include "gbuffer/watched.h"

namespace relume::bench {
namespace {

template <class Call>
auto guarded(const std::string& device, const Call& call) -> decltype(call()) {
  const InForeignCode driver(Foreign::driver);
  try {
    return call();
  } catch (const cl::Error& error) {
    rethrow(error, device);
  }
}

cl::Program built(const cl::Context& context, const cl::Device& device, const std::string& name, const std::string& text,
                  const std::string& options) {
  cl::Program program(context, text);
  try {
    program.build({device}, options.c_str());
  } catch (const cl::Error&) {
    const std::string log = program.getBuildInfo<CL_PROGRAM_BUILD_LOG>(device);
    throw Error(ErrorKind::device, name + ": a kernel of the benchmark does not build: " + log.substr(0, log.find('\n')));
  }
  return program;
}

}  // namespace

cl::Device opencl_device(const DeviceInfo& info, int threads) {
  const cl::Device whole = opencl_devices().at(std::size_t(info.index));
  if (threads == 0) return whole;
  return guarded(info.name, [&] {
    const cl_device_partition_property counts[] = {CL_DEVICE_PARTITION_BY_COUNTS, threads, CL_DEVICE_PARTITION_BY_COUNTS_LIST_END, 0};
    std::vector<cl::Device> parts;
    cl::Device(whole).createSubDevices(counts, &parts);
    return parts.front();
  });
}

OwnProgram::OwnProgram(const DeviceInfo& info, const std::string& text, const std::string& options, int threads)
    : name_(info.name), device_(opencl_device(info, threads)) {
  guarded(name_, [&] {
    context_ = cl::Context(device_);
    queue_ = cl::CommandQueue(context_, device_);
    program_ = built(context_, device_, name_, text, options);
  });
}

cl::Buffer OwnProgram::buffer(std::size_t floats) {
  return guarded(name_, [&] { return cl::Buffer(context_, CL_MEM_READ_WRITE, floats * sizeof(float)); });
}

cl::Buffer OwnProgram::buffer(const float* data, std::size_t floats) {
  return guarded(name_,
                 [&] { return cl::Buffer(context_, CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR, floats * sizeof(float), const_cast<float*>(data)); });
}

void OwnProgram::read(const cl::Buffer& buffer, float* data, std::size_t floats) {
  guarded(name_, [&] { queue_.enqueueReadBuffer(buffer, CL_TRUE, 0, floats * sizeof(float), data); });
}

cl::Kernel OwnProgram::kernel(const std::string& name) {
  return guarded(name_, [&] { return cl::Kernel(program_, name.c_str()); });
}

void OwnProgram::run(const cl::Kernel& kernel, std::size_t items, std::size_t group) {
  guarded(name_, [&] {
    queue_.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(items), group ? cl::NDRange(group) : cl::NullRange);
    queue_.finish();
  });
}

}  // namespace relume::bench
