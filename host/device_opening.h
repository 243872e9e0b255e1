// A device that is opened in a thread of its own: loading drivers takes as long as understanding a file does, and neither needs the other.
#pragma once

#include <future>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "host/device.h"

namespace relume {

/// As open_device; the twin where none is asked for and there is no OpenCL device.
std::unique_ptr<Device> open_device_or_twin(const std::string& selector);

class DeviceOpening {
 public:
  /// Begins to open the device that `selector` means (host/device.h).
  explicit DeviceOpening(const std::string& selector, Precision precision = Precision::exact);

  /// The device, once it is open and has passed the self-test of every program, with each of those for environments. Where none was asked for and
  /// none is to be had, the C++ twin, and a sentence in `notes`. Throws Error{device}.
  std::unique_ptr<Device> tested(const std::vector<Choice>& programs, std::vector<std::string>& notes, std::span<const Entry> environments = {});

 private:
  std::string selector_;
  std::future<std::unique_ptr<Device>> device_;
};

}  // namespace relume
