// A run of the benchmark: what it was asked, what it runs on, and what was found so far.
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "bench/bench_device.h"
#include "bench/claim.h"
#include "bench/options.h"
#include "bench/subject.h"

namespace relume::bench {

/// Subjects that share memory and are measured in turns.
struct Group {
  std::vector<std::string> names;
  /// Of the names that `is_wanted`, ready to run, their images checked. Throws Error{device}.
  std::function<std::vector<Subject>(const std::function<bool(const std::string&)>& is_wanted)> make;
  std::vector<Claim> claims{};
  /// Adds what was measured within the subjects, where there is such.
  std::function<void(std::vector<Measurement>&)> finish{};
};

struct Bench {
  Options options;
  std::vector<BenchDevice> devices;
  Limits processor, one_thread;  ///< from C++: on all threads, on one
  std::vector<Measurement> measurements{};
  std::vector<Weighed> weighed{};

  Roof processor_roof() const { return {processor.fused, int(std::max(1u, std::thread::hardware_concurrency()))}; }
  /// Whether dimensions that no option narrows are open.
  bool is_open() const { return options.filter.has_value(); }
};

}  // namespace relume::bench
