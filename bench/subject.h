// One thing that is measured, what it does in one go, and what it took.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace relume::bench {

/// Pixels times lights, and which of them are meant: "brute", every pixel under every light; "culled", the pairs that tiles of 16x16 pixels are left
/// with; "in range", those where light arrives at all.
struct PixelLights {
  std::string counted;
  double pairs = 0;
};

/// What one go does, counted from its description.
struct Work {
  std::vector<PixelLights> pixel_lights;  ///< the first is what rates are compared by
  double flops = 0;                       ///< useful ones: bench/operations.h
  double bytes = 0;                       ///< read and written at least once

  double pairs() const { return pixel_lights.empty() ? 0 : pixel_lights.front().pairs; }
};

/// What arithmetic can reach at most on the processors that a subject has.
struct Roof {
  double flops = 0;  ///< flop/s, measured; 0: not known
  int threads = 1;
};

struct Subject {
  std::string name;           ///< "kernel/lambert+ggx/point/64/1920x1080/portable/16"
  std::function<void()> run;  ///< one go; done when it returns
  Work work;
  std::string verdict;  ///< its image against the twin's: "equal", "within 3e-06"; empty: it makes none
  Roof roof{};
};

struct Measurement {
  Subject subject;
  std::vector<double> seconds, cpu_seconds;  ///< of one go, for each round; all threads' processor time
  std::int64_t goes = 0;                     ///< in each round

  double least() const;
  double median() const;
  double per_second(double amount) const { return amount / median(); }
};

/// By linear interpolation between the sorted values; `share` in 0..1.
double quantile(std::vector<double> values, double share);

}  // namespace relume::bench
