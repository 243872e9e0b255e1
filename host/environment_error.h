// How far samples leave a picture from what many more would give, told by the samples themselves: the two halves of each pixel's differ by about
// that.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "gbuffer/gbuffer.h"
#include "host/environment_options.h"

namespace relume {

class EnvironmentError {
 public:
  /// A band: its total, and the plane of squared differences.
  void add(const GBuffer& gbuffer, const Planes& out, int plane);

  /// PSNR, dB: the peak is the picture's 99.9th percentile, within a sixteenth of it. Infinity where nothing differs.
  double decibels() const;
  /// "environment: 64 samples a pixel, estimated error 41.2 dB (...)"
  std::string sentence(const EnvironmentOptions& options) const;

 private:
  double squares_ = 0;
  std::int64_t pixels_ = 0;
  std::array<std::int64_t, 1 << 12> values_{};  ///< how many begin with these bits: exponent and four of the mantissa
};

}  // namespace relume
