// A device as the benchmark sees it: a short name for it, what it can do at best, and its parts.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bench/subject.h"
#include "host/device.h"

namespace relume::bench {

/// Measured; 0: not known.
struct Limits {
  double fused = 0, separate = 0;        ///< flop/s: multiply-add in one instruction, and in two
  double read = 0, copy = 0, triad = 0;  ///< bytes/s, read and written
  double launch = 0;                     ///< seconds for a kernel that does nothing, until it is known to be done
};

struct BenchDevice {
  std::string label;     ///< of the driver, for names of subjects: "portable", "intel", "twin"
  std::string selector;  ///< for open_device
  DeviceInfo info;
  Limits limits;

  bool is_twin() const { return info.index < 0; }
  /// With so many lanes; 0: its own.
  std::unique_ptr<Device> open(int lanes = 0) const;
  /// With so many of its compute units. Null where the driver does not divide it.
  std::unique_ptr<Device> open_threads(int threads) const;
  std::unique_ptr<Device> open_one_thread() const { return open_threads(1); }
  /// Of the whole, and of so many of its units.
  Roof roof() const;
  Roof roof(int threads) const;
  int compute_units() const;  ///< 0 of the twin
  /// Lane counts that its kernels can be built for, the device's own first.
  std::vector<int> lanes() const;
};

/// Those that the selectors name, in each precision; "all": every OpenCL device and the twin; none given: the best there is. Throws Error{device}.
std::vector<BenchDevice> bench_devices(const std::vector<std::string>& selectors, const std::vector<Precision>& precisions);

}  // namespace relume::bench
