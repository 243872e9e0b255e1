// Pixels of filtered layers that are means over several surfaces, taken apart into those surfaces: light is not linear in normals and positions,
// so each surface is to be shaded by itself, and the pixel shows their lights' mean.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gbuffer/reading.h"

namespace relume {

struct Mixtures {
  /// One surface's share of a pixel.
  struct Sample {
    std::int64_t pixel;  ///< in the window, row by row
    float coverage;      ///< of the pixel, 0..1
    std::uint32_t id;
  };
  std::vector<Sample> samples;             ///< those of a pixel are adjacent, the largest share first
  std::vector<std::string> roles;          ///< whose layers the values are
  std::vector<int> firsts;                 ///< of each role: its first component
  int components = 0;                      ///< values of a sample
  std::vector<float> values;               ///< of each sample: layers as stored, but of the one surface alone, as if it covered the pixel
  std::int64_t apart = 0;                  ///< pixels of several surfaces
  std::int64_t partial = 0;                ///< pixels of one surface and background
  std::int64_t unexplained = 0;            ///< pixels that are means, of what the pixels around do not tell
  std::int64_t replaced = 0;               ///< pixels that the samples stand for
  static constexpr int most_surfaces = 3;  ///< of a pixel: where three objects meet; a fourth would explain anything

  bool first_of_pixel(std::size_t sample) const { return sample == 0 || samples[sample - 1].pixel != samples[sample].pixel; }
  std::int64_t extras() const { return std::int64_t(samples.size()) - replaced; }  ///< samples beside each pixel's first
};

/// Explains pixels by the surfaces that the pixels around them show. Bands agree with the whole.
Mixtures find_mixtures(const ExrFile& file, const Reading& reading, const Window& window, const std::vector<std::string>& roles);

}  // namespace relume
