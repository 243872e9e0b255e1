// Subjects device/<label>/<limit>: kernels of device_limits.cl, and their likes in C++ under the label "cpp".
#include "bench/device_limits.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <memory>
#include <thread>

#include "bench/native_limits.h"
#include "bench/own_kernel.h"
#include "bench/texts.h"

namespace relume::bench {
namespace {

constexpr std::size_t array_floats = std::size_t(1) << 25;  // 128 MiB: beyond any cache of today
constexpr int chunk = 64;                                   // vectors that a work-item takes: launching it costs nothing beside them
constexpr int steps = 20000;                                // of the chains: 0.1 ms and more

struct Arrays {
  OwnProgram program;
  cl::Buffer a, b, c;
};

std::string options_for(const DeviceInfo& info) {
  return "-DLANES=" + std::to_string(info.lanes) + " -DCHUNK=" + std::to_string(chunk) + " -DCONTIGUOUS=" + (info.is_cpu ? "1" : "0");
}

Subject chains(const BenchDevice& device, const std::shared_ptr<Arrays>& arrays, const std::string& name) {
  // A CPU's thread is full with one work-item; a GPU's unit needs thousands to hide what each waits for.
  const std::size_t items = std::size_t(device.compute_units()) * (device.info.is_cpu ? 16 : 2048);
  cl::Kernel kernel = arrays->program.kernel(name);
  kernel.setArg(0, arrays->c);
  kernel.setArg(1, 0.5f);
  kernel.setArg(2, 0.999f);
  kernel.setArg(3, 0.001f);
  kernel.setArg(4, steps);
  Work work;
  work.flops = double(items) * device.info.lanes * 12 * 2 * steps;
  return {"device/" + device.label + "/" + name, [=] { arrays->program.run(kernel, items); }, work, {}, {}};
}

Subject memory(const BenchDevice& device, const std::shared_ptr<Arrays>& arrays, const std::string& name, int arrays_moved) {
  cl::Kernel kernel = arrays->program.kernel(name);
  kernel.setArg(0, arrays->a);
  kernel.setArg(1, arrays->b);
  kernel.setArg(2, arrays->c);
  const std::size_t items = arrays_moved == 0 ? 1 : array_floats / std::size_t(device.info.lanes) / chunk;
  Work work;
  work.bytes = double(arrays_moved) * double(array_floats) * sizeof(float);
  return {"device/" + device.label + "/" + name, [=] { arrays->program.run(kernel, items); }, work, {}, {}};
}

std::vector<Subject> opencl_limits(const BenchDevice& device) {
  OwnProgram program(device.info, text_device_limits, options_for(device.info));
  const std::vector<float> zeros(array_floats);
  const auto filled = [&] { return program.buffer(zeros.data(), array_floats); };
  const cl::Buffer a = filled(), b = filled(), c = filled();
  const auto arrays = std::make_shared<Arrays>(Arrays{std::move(program), a, b, c});
  return {chains(device, arrays, "fused"),   chains(device, arrays, "separate"), memory(device, arrays, "read", 1),
          memory(device, arrays, "copy", 2), memory(device, arrays, "triad", 3), memory(device, arrays, "nothing", 0)};
}

/// `body(first, last)` over all floats, a share for each thread.
template <class Body>
void in_shares(const Body& body) {
  const std::size_t shares = std::max(1u, std::thread::hardware_concurrency()), each = array_floats / shares;
  tbb::parallel_for(std::size_t(0), shares, [&](std::size_t k) { body(k * each, each); });
}

std::vector<Subject> native_limits() {
  struct Memory {
    std::vector<float> a = std::vector<float>(array_floats), b = a, c = a;
  };
  const auto m = std::make_shared<Memory>();
  const auto sink = std::make_shared<std::vector<float>>(1024);
  const int threads = int(std::max(1u, std::thread::hardware_concurrency())), shares = 4 * threads;
  const auto moving = [](int arrays) {
    Work work;
    work.bytes = double(arrays) * double(array_floats) * sizeof(float);
    return work;
  };
  Work one, all;
  one.flops = native_chain_flops * steps;
  all.flops = one.flops * shares;
  return {
      {"device/cpp/fused_1_thread", [=] { (*sink)[0] = native_chains(steps); }, one, {}, {}},
      {"device/cpp/fused", [=] { tbb::parallel_for(0, shares, [&](int k) { (*sink)[std::size_t(k) % 1024] = native_chains(steps); }); }, all, {}, {}},
      {"device/cpp/read", [=] { in_shares([&](std::size_t i, std::size_t n) { (*sink)[i % 1024] = native_read(&m->a[i], n); }); }, moving(1), {}, {}},
      {"device/cpp/copy", [=] { in_shares([&](std::size_t i, std::size_t n) { native_copy(&m->a[i], &m->c[i], n); }); }, moving(2), {}, {}},
      {"device/cpp/triad",
       [=] { in_shares([&](std::size_t i, std::size_t n) { native_triad(&m->a[i], &m->b[i], &m->c[i], n); }); },
       moving(3),
       {},
       {}}};
}

const Measurement* find(const std::vector<Measurement>& all, const std::string& name) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Measurement& m) { return m.subject.name == name; });
  return found == all.end() ? nullptr : &*found;
}

/// The best that was seen: a limit is what the device can do, not what others left of it.
double bytes_per_second(const std::vector<Measurement>& all, const std::string& name) {
  const Measurement* const m = find(all, name);
  return m ? m->subject.work.bytes / m->least() : 0;
}

/// On a CPU from processor time, which others who run beside do not lengthen: what its threads could do if each had a processor to itself.
double flops_per_second(const std::vector<Measurement>& all, const std::string& name, int cpu_threads) {
  const Measurement* const m = find(all, name);
  if (!m) return 0;
  const double by_clock = m->subject.work.flops / m->least();
  return cpu_threads == 0 ? by_clock : std::max(by_clock, m->subject.work.flops * cpu_threads / quantile(m->cpu_seconds, 0));
}

/// `cpu_threads`: 0 of what is no CPU.
Limits limits_of(const std::vector<Measurement>& all, const std::string& label, int cpu_threads) {
  const std::string prefix = "device/" + label + "/";
  Limits limits;
  limits.fused = flops_per_second(all, prefix + "fused", cpu_threads);
  limits.separate = flops_per_second(all, prefix + "separate", cpu_threads);
  limits.read = bytes_per_second(all, prefix + "read");
  limits.copy = bytes_per_second(all, prefix + "copy");
  limits.triad = bytes_per_second(all, prefix + "triad");
  if (const Measurement* const nothing = find(all, prefix + "nothing")) limits.launch = nothing->median();
  return limits;
}

}  // namespace

void measure_limits(Bench& bench) {
  const auto keep = [&](const std::vector<Subject>& subjects) {
    std::vector<Measurement> measured = measure(subjects, bench.options.rounds);
    bench.measurements.insert(bench.measurements.end(), measured.begin(), measured.end());
    return measured;
  };
  const std::vector<Measurement> native = keep(native_limits());
  bench.processor = bench.one_thread = limits_of(native, "cpp", int(std::max(1u, std::thread::hardware_concurrency())));
  bench.one_thread.fused = flops_per_second(native, "device/cpp/fused_1_thread", 1);
  for (BenchDevice& d : bench.devices)
    d.limits = d.is_twin() ? bench.processor : limits_of(keep(opencl_limits(d)), d.label, d.info.is_cpu ? d.compute_units() : 0);
}

}  // namespace relume::bench
