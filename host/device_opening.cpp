// DeviceOpening: a future, and the self-test.
#include "host/device_opening.h"

#include "gbuffer/error.h"
#include "host/driver_environment.h"
#include "host/self_test.h"
#include "host/twin.h"

namespace relume {

std::unique_ptr<Device> open_device_or_twin(const std::string& selector) {
  return open_device(selector.empty() && list_devices().empty() ? "twin" : selector);
}

DeviceOpening::DeviceOpening(const std::string& selector, Precision precision) : selector_(selector) {
  prepare_driver_environment();  // sets variables: not while another thread may read some
  device_ = std::async(std::launch::async, [selector, precision] { return open_device(selector, 0, precision); });
}

std::unique_ptr<Device> DeviceOpening::tested(const std::vector<Choice>& programs, std::vector<std::string>& notes,
                                              std::span<const Entry> environments) try {
  std::unique_ptr<Device> device = device_.get();
  if (device->info().name != "twin")
    for (const Choice& program : programs) {
      self_test(*device, program);
      for (const Entry environment : environments) self_test(*device, program, environment);
    }
  return device;
} catch (const Error& error) {
  if (!selector_.empty() || error.kind != ErrorKind::device) throw;
  notes.push_back(std::string(error.what()) + "; shading on the C++ twin instead");
  return open_twin();
}

}  // namespace relume
