// The OpenCL device: buffers over the caller's planes, one program for each choice of lobes, work in slices that can be interrupted.
#include <algorithm>
#include <array>
#include <map>

#include "gbuffer/error.h"
#include "gbuffer/watched.h"
#include "host/light_lists.h"
#include "host/opencl.h"
#include "host/program.h"

namespace relume {
namespace {

using Kernel = cl::KernelFunctor<cl::Buffer, cl::Buffer, cl::Buffer, cl::Buffer, cl::Buffer, cl::Buffer, cl_int>;

/// Work-items in a work-group on a CPU: enough to hide the scheduler's lock, few enough that one local size serves every launch (PoCL compiles anew
/// for each).
constexpr int group = 16;
/// Pixels times lights between two looks at the interrupt flag: about 0.1 s on one slow core.
constexpr std::int64_t slice_work = 40'000'000;

#define RELUME_ENTRY_TEXT(name) #name,
constexpr const char* entry_names[] = {RELUME_ENTRIES(RELUME_ENTRY_TEXT)};

class OpenClDevice : public Device {
 public:
  OpenClDevice(const cl::Device& device, const DeviceInfo& info) : info_(info), device_(device), context_(device), queue_(context_, device) {}

  const DeviceInfo& info() const override { return info_; }
  std::unique_ptr<Band> bind(const BandData& data) override;

  /// The entry point `name` of the program of `choice`.
  Kernel& kernel(const std::string& name, const Choice& choice) {
    const std::pair key{name, std::array{choice.diffuse, choice.specular, choice.fresnel, choice.shadowing, choice.distribution}};
    const auto found = kernels_.find(key);
    if (found != kernels_.end()) return found->second;
    return kernels_.emplace(key, Kernel(build_program(context_, device_, info_, name, choice), name)).first->second;
  }

  const cl::Context& context() const { return context_; }
  cl::CommandQueue& queue() { return queue_; }

 private:
  DeviceInfo info_;
  cl::Device device_;
  cl::Context context_;
  cl::CommandQueue queue_;
  std::map<std::pair<std::string, std::array<int, 5>>, Kernel> kernels_;
};

/// A buffer over the caller's memory: a CPU device uses it in place. OpenCL refuses empty buffers, so `spare` stands in.
template <class T>
cl::Buffer over(const cl::Context& context, cl_mem_flags access, T* data, std::size_t bytes) {
  static std::array<char, 64> spare{};
  if (bytes == 0) return cl::Buffer(context, access | CL_MEM_USE_HOST_PTR, spare.size(), spare.data());
  return cl::Buffer(context, access | CL_MEM_USE_HOST_PTR, bytes, const_cast<void*>(static_cast<const void*>(data)));
}

class OpenClBand : public Band {
 public:
  OpenClBand(OpenClDevice& device, const BandData& data)
      : device_(device),
        data_(data),
        planes_(over(device.context(), CL_MEM_READ_ONLY, data.planes->data(), data.planes->bytes())),
        lights_(over(device.context(), CL_MEM_READ_ONLY, data.lights.data(), data.lights.size_bytes())),
        lists_(over(device.context(), CL_MEM_READ_ONLY, data.lists.data(), data.lists.size_bytes())),
        tables_(over(device.context(), CL_MEM_READ_ONLY, data.tables.data(), data.tables.size_bytes())),
        out_(over(device.context(), CL_MEM_READ_WRITE, data.out->data(), data.out->bytes())) {}

  void shade(const Choice& choice, const Frame& frame, const Progress& progress) override {
    launch(Entry::shade, choice, frame, lights_met(frame, data_.lists), progress);
  }
  void run(Entry entry, const Choice& choice, const Frame& frame) override { launch(entry, choice, frame, 1, {}); }
  void add_environment(Entry entry, const Choice& choice, const Frame& frame, const Progress& progress) override {
    launch(entry, choice, frame, environment_work, progress);
  }

  void finish() override try {
    const InForeignCode driver(Foreign::driver);
    const std::size_t bytes = data_.out->bytes();
    if (bytes == 0) return;
    void* mapped = device_.queue().enqueueMapBuffer(out_, CL_TRUE, CL_MAP_READ, 0, bytes);
    device_.queue().enqueueUnmapMemObject(out_, mapped);
    device_.queue().finish();
  } catch (const cl::Error& error) {
    rethrow(error, device_.info().name);
  }

 private:
  /// Launches slice after slice of pixels; `work`: how much a pixel costs, in lights.
  void launch(Entry entry, const Choice& choice, const Frame& frame, std::int64_t work, const Progress& progress) try {
    const InForeignCode driver(Foreign::driver);
    const cl::Buffer constants(device_.context(), CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR, sizeof frame, const_cast<Frame*>(&frame));
    Kernel& kernel = device_.kernel(entry_names[std::size_t(entry)], choice);
    const int lanes = device_.info().lanes, local = lanes > 1 ? group : RELUME_STAGED_ITEMS;
    const std::int64_t unit = std::int64_t(lanes) * local, slice = std::max<std::int64_t>(1, slice_work / work / unit) * unit;
    for (std::int64_t first = 0; first < frame.pixels; first += slice) {
      const std::int64_t pixels = std::min<std::int64_t>(slice, frame.pixels - first);
      const std::size_t items = std::size_t((pixels + unit - 1) / unit * local);
      kernel(cl::EnqueueArgs(device_.queue(), cl::NDRange(items), cl::NDRange(std::size_t(local))), planes_, constants, lights_, lists_, tables_,
             out_, cl_int(first));
      device_.queue().finish();
      beat();
      if (progress) progress(pixels);
    }
  } catch (const cl::Error& error) {
    rethrow(error, device_.info().name);
  }

  OpenClDevice& device_;
  BandData data_;
  cl::Buffer planes_, lights_, lists_, tables_, out_;
};

std::unique_ptr<Band> OpenClDevice::bind(const BandData& data) try {
  const InForeignCode driver(Foreign::driver);
  const std::size_t largest = std::max(data.planes->bytes(), data.out->bytes());
  if (largest > info_.max_allocation)
    throw Error(ErrorKind::memory, info_.name + ": a band of " + std::to_string(largest) + " bytes, the device takes " +
                                       std::to_string(info_.max_allocation) + " in one buffer (--memory makes bands smaller)");
  return std::make_unique<OpenClBand>(*this, data);
} catch (const cl::Error& error) {
  rethrow(error, info_.name);
}

}  // namespace

std::unique_ptr<Device> open_opencl_device(const cl::Device& device, const DeviceInfo& info) try {
  const InForeignCode driver(Foreign::driver);
  return std::make_unique<OpenClDevice>(device, info);
} catch (const cl::Error& error) {
  rethrow(error, info.name);
}

}  // namespace relume
