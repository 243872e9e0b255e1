// EnvironmentError: sums, and a histogram by the leading bits of the values.
#include "host/environment_error.h"

#include <bit>
#include <cmath>
#include <cstdio>
#include <limits>

#include "host/environment_shading.h"
#include "host/output_layout.h"

namespace relume {
namespace {

constexpr int dropped_bits = 19;  // of a positive float: 8 of exponent and 4 of mantissa remain

}  // namespace

void EnvironmentError::add(const GBuffer& gbuffer, const Planes& out, int plane) {
  const float *const coverage = gbuffer.planes.plane(gbuffer.coverage.first), *const squares = out.plane(plane);
  for (std::int64_t i = 0; i < gbuffer.samples(); ++i) {
    if (!(coverage[i] > 0)) continue;
    squares_ += double(squares[i]);
    ++pixels_;
    for (int c = 0; c < 3; ++c) ++values_[std::bit_cast<std::uint32_t>(std::fabs(out.plane(OutputLayout::total + c)[i])) >> dropped_bits];
  }
}

double EnvironmentError::decibels() const {
  if (squares_ == 0) return std::numeric_limits<double>::infinity();
  std::int64_t left = pixels_ * 3 / 1000;
  std::uint32_t bits = std::uint32_t(values_.size()) - 1;
  while (bits > 0 && (left -= values_[bits]) >= 0) --bits;
  const double peak = double(std::bit_cast<float>(bits << dropped_bits));
  return 10 * std::log10(peak * peak / (squares_ / double(pixels_)));
}

std::string EnvironmentError::sentence(const EnvironmentOptions& options) const {
  const std::string begin = "environment: " + std::to_string(samples_of(options)) + " samples a pixel, ";
  if (squares_ == 0) return begin + "which agree";
  char text[64];
  std::snprintf(text, sizeof text, "estimated error %.1f dB", decibels());
  return begin + text + " (PSNR of the picture, by how much odd and even samples differ; rather too low)";
}

}  // namespace relume
