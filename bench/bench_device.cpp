// Labels from the platform's first word; parts as OpenCL's sub-devices.
#include "bench/bench_device.h"

#include <algorithm>
#include <cctype>
#include <thread>

#include "bench/own_kernel.h"
#include "gbuffer/error.h"
#include "host/twin.h"

namespace relume::bench {
namespace {

/// "Portable Computing Language" -> "portable", "Intel(R) OpenCL" -> "intel".
std::string first_word(const std::string& platform) {
  std::string word;
  for (const unsigned char c : platform) {
    if (!std::isalnum(c)) break;
    word += char(std::tolower(c));
  }
  return word.empty() ? "opencl" : word;
}

void add(std::vector<BenchDevice>& all, const DeviceInfo& info) {
  const std::string selector = info.index < 0 ? "twin" : std::to_string(info.index);
  const auto is_there = [&](const BenchDevice& d) { return d.selector == selector && d.info.precision == info.precision; };
  if (std::any_of(all.begin(), all.end(), is_there)) return;
  const std::string word = info.index < 0 ? "twin" : first_word(info.platform) + (info.precision == Precision::relaxed ? "_relaxed" : "");
  std::string label = word;
  for (int n = 2; std::any_of(all.begin(), all.end(), [&](const BenchDevice& d) { return d.label == label; }); ++n) label = word + std::to_string(n);
  all.push_back({label, selector, info, {}});
}

}  // namespace

std::unique_ptr<Device> BenchDevice::open(int lanes) const { return open_device(selector, lanes, info.precision); }

int BenchDevice::compute_units() const { return is_twin() ? 0 : int(opencl_device(info).getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>()); }

std::unique_ptr<Device> BenchDevice::open_threads(int threads) const try {
  if (is_twin() || !info.is_cpu) return nullptr;
  return open_opencl_device(opencl_device(info, threads), info);
} catch (const Error&) {
  return nullptr;  // not every driver divides its device
}

Roof BenchDevice::roof() const {
  return {limits.fused, is_twin() ? int(std::max(1u, std::thread::hardware_concurrency())) : std::max(1, compute_units())};
}

Roof BenchDevice::roof(int threads) const { return {roof().flops * threads / roof().threads, threads}; }

std::vector<int> BenchDevice::lanes() const {
  std::vector<int> all{info.lanes};
  for (const int lanes : is_twin() ? twin_lanes() : std::vector<int>{1, 4, 8, 16})
    if (lanes != info.lanes) all.push_back(lanes);
  return all;
}

std::vector<BenchDevice> bench_devices(const std::vector<std::string>& selectors, const std::vector<Precision>& precisions) {
  std::vector<DeviceInfo> exact;
  for (const std::string& selector : selectors) {
    if (selector == "all") {
      for (const DeviceInfo& info : list_devices()) exact.push_back(info);
      exact.push_back(open_twin()->info());
    } else {
      exact.push_back(open_device(selector)->info());
    }
  }
  if (selectors.empty()) exact.push_back(list_devices().empty() ? open_twin()->info() : open_device("")->info());
  std::vector<BenchDevice> all;
  for (const DeviceInfo& info : exact)
    for (const Precision precision : precisions)
      add(all, precision == Precision::exact || info.index < 0 ? info : open_device(std::to_string(info.index), 0, precision)->info());
  return all;
}

}  // namespace relume::bench
