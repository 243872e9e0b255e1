// Wall-clock time by stage: each lap goes to the stage that it ends. Work that overlaps has a watch for each thread of it.
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

  /// What has passed since the last lap goes to no stage.
  void start() { last_ = std::chrono::steady_clock::now(); }

  /// Adds the seconds since the last call (or the start) to a stage.
  void lap(const std::string& stage) {
    const auto now = std::chrono::steady_clock::now();
    find(stage) += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }

  void add(const Stopwatch& other) {
    for (const auto& [stage, seconds] : other.laps_) find(stage) += seconds;
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
