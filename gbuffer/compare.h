// How far two images are apart: PSNR and errors for each layer, over the pixels that both hold.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace relume {

struct LayerDifference {
  std::string layer;        ///< "" for the root's R G B; alpha stands apart as "A"
  std::int64_t values = 0;  ///< pixels times channels compared
  double psnr = 0;          ///< dB, peak = the reference's 99.9th percentile of |value|; infinite where the two are equal
  double peak = 0;
  double max_error = 0, mean_error = 0;  ///< absolute
  int worst_x = 0, worst_y = 0;          ///< display-window coordinates of the largest error
  std::string worst_channel;
  std::int64_t not_finite = 0;  ///< values that are NaN or infinite in one image alone: an infinite error
};

struct ImageComparison {
  std::vector<LayerDifference> layers;
  std::vector<std::string> only_in_image, only_in_reference;  ///< channels
};

/// Channels are matched by name over all parts, pixels by display-window coordinates. Throws Error{input} where nothing can be compared.
ImageComparison compare_images(const std::filesystem::path& image, const std::filesystem::path& reference);

}  // namespace relume
