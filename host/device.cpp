// Finding a device by what the user called it.
#include "host/device.h"

#include <algorithm>
#include <cctype>

#include "gbuffer/error.h"
#include "host/opencl.h"
#include "host/twin.h"

namespace relume {
namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

bool contains(const std::string& text, const std::string& part) { return lower(text).find(lower(part)) != std::string::npos; }

/// The position in `infos` that the selector means, or -1.
int select(const std::vector<DeviceInfo>& infos, const std::string& selector) {
  const auto first = [&](auto&& wanted) {
    const auto found = std::find_if(infos.begin(), infos.end(), wanted);
    return found == infos.end() ? -1 : int(found - infos.begin());
  };
  const auto gpu = [](const DeviceInfo& d) { return d.is_gpu; };
  const auto cpu = [](const DeviceInfo& d) { return d.is_cpu; };
  if (selector.empty()) {
    const int best = first(gpu) >= 0 ? first(gpu) : first(cpu);
    return best >= 0 ? best : infos.empty() ? -1 : 0;
  }
  if (selector == "gpu") return first(gpu);
  if (selector == "cpu") return first(cpu);
  if (selector.size() < 4 && std::all_of(selector.begin(), selector.end(), [](unsigned char c) { return std::isdigit(c); }))
    return std::stoi(selector) < int(infos.size()) ? std::stoi(selector) : -1;
  return first([&](const DeviceInfo& d) { return contains(d.name, selector) || contains(d.platform, selector); });
}

std::string names_of(const std::vector<DeviceInfo>& infos) {
  std::string names;
  for (const DeviceInfo& info : infos) names += (names.empty() ? "" : ", ") + info.name;
  return names.empty() ? "none" : names;
}

}  // namespace

std::vector<DeviceInfo> list_devices() {
  std::vector<DeviceInfo> infos;
  for (const cl::Device& device : opencl_devices()) {
    infos.push_back(describe(device));
    infos.back().index = int(infos.size()) - 1;
  }
  return infos;
}

std::unique_ptr<Device> open_device(const std::string& selector, int lanes, Precision precision) {
  if (selector == "twin") return open_twin(lanes);
  const std::vector<cl::Device> devices = opencl_devices();
  std::vector<DeviceInfo> infos;
  for (const cl::Device& device : devices) infos.push_back(describe(device));
  const int chosen = select(infos, selector);
  if (chosen < 0)
    throw Error(ErrorKind::device, (selector.empty() ? "no OpenCL device" : "no OpenCL device named \"" + selector + "\"") +
                                       " (found: " + names_of(infos) + "; --device twin needs none)");
  DeviceInfo info = infos[chosen];
  info.index = chosen;
  if (lanes > 0) info.lanes = lanes;
  info.precision = precision;
  if (precision == Precision::relaxed) info.correctly_rounded = false;
  return open_opencl_device(devices[chosen], info);
}

}  // namespace relume
