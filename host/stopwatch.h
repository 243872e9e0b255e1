// Wall-clock time by stage: each lap goes to the stage that it ends.
#pragma once

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace relume {

class Stopwatch {
 public:
  using Laps = std::vector<std::pair<std::string, double>>;

  /// Adds the seconds since the last call (or the start) to a stage.
  void lap(const std::string& stage) {
    const auto now = std::chrono::steady_clock::now();
    find(stage) += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }

  /// Stage -> seconds, in the order of their first lap.
  const Laps& laps() const { return laps_; }
  double seconds(const std::string& stage) { return find(stage); }

 private:
  double& find(const std::string& stage) {
    const auto found = std::find_if(laps_.begin(), laps_.end(), [&](const auto& lap) { return lap.first == stage; });
    return found == laps_.end() ? laps_.emplace_back(stage, 0.0).second : found->second;
  }

  Laps laps_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace relume
