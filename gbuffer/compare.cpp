// compare_images: channel by channel, gathered by layer.
#include "gbuffer/compare.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "gbuffer/error.h"
#include "gbuffer/exr_file.h"

namespace relume {
namespace {

/// Channel name -> the part that has it; the first part wins.
std::map<std::string, int> channels_of(const ExrFile& file) {
  std::map<std::string, int> all;
  for (const Part& part : file.parts())
    for (const Channel& channel : part.channels) all.emplace(channel.name, part.index);
  return all;
}

std::string layer_of(const std::string& channel) {
  if (channel == "A") return channel;
  const std::size_t dot = channel.rfind('.');
  return dot == std::string::npos ? "" : channel.substr(0, dot);
}

std::vector<float> samples(const ExrFile& file, int part, const std::string& channel, const Window& window) {
  std::vector<float> values(std::size_t(window.pixels()));
  const Destination destination{channel, SampleType::float32, values.data(), sizeof(float), sizeof(float) * std::size_t(window.width())};
  file.read(part, window, {&destination, 1});
  return values;
}

/// One layer's sums while its channels go by.
struct Sums {
  LayerDifference difference;
  double squares = 0, absolute = 0;
  std::vector<float> magnitudes;  // of the reference, for the peak

  void add(const std::string& channel, const Window& window, const std::vector<float>& image, const std::vector<float>& reference) {
    for (std::size_t i = 0; i < image.size(); ++i) {
      const double a = image[i], b = reference[i];
      double error = std::fabs(a - b);
      if (!std::isfinite(a) || !std::isfinite(b)) {
        const bool same = a == b || (std::isnan(a) && std::isnan(b));
        if (!same) ++difference.not_finite;
        error = same ? 0 : std::numeric_limits<double>::infinity();
      }
      squares += error * error;
      absolute += error;
      magnitudes.push_back(std::isfinite(b) ? float(std::fabs(b)) : 0.0f);
      if (error > difference.max_error || difference.worst_channel.empty()) {
        difference.max_error = error;
        difference.worst_channel = channel;
        difference.worst_x = window.min_x + int(i % std::size_t(window.width()));
        difference.worst_y = window.min_y + int(i / std::size_t(window.width()));
      }
    }
    difference.values += std::int64_t(image.size());
  }

  LayerDifference finish() {
    const std::size_t rank = std::min(magnitudes.size() - 1, std::size_t(double(magnitudes.size()) * 0.999));
    std::nth_element(magnitudes.begin(), magnitudes.begin() + std::ptrdiff_t(rank), magnitudes.end());
    difference.peak = magnitudes[rank] > 0 ? magnitudes[rank] : 1;  // a black reference: errors count against 1
    difference.mean_error = absolute / double(difference.values);
    difference.psnr = -10 * std::log10(squares / double(difference.values) / (difference.peak * difference.peak));
    return difference;
  }
};

}  // namespace

ImageComparison compare_images(const std::filesystem::path& image_path, const std::filesystem::path& reference_path) {
  const ExrFile image(image_path), reference(reference_path);
  const auto ours = channels_of(image), theirs = channels_of(reference);
  ImageComparison result;
  std::map<std::string, Sums> layers;
  for (const auto& [channel, part] : ours) {
    const auto found = theirs.find(channel);
    if (found == theirs.end()) {
      result.only_in_image.push_back(channel);
      continue;
    }
    const Window window = intersection(image.parts()[std::size_t(part)].data_window, reference.parts()[std::size_t(found->second)].data_window);
    if (window.empty()) throw Error(ErrorKind::input, image_path.string() + ": its data window does not meet that of " + reference_path.string());
    Sums& sums = layers[layer_of(channel)];
    sums.difference.layer = layer_of(channel);
    sums.add(channel, window, samples(image, part, channel, window), samples(reference, found->second, channel, window));
  }
  for (const auto& [channel, part] : theirs)
    if (!ours.contains(channel)) result.only_in_reference.push_back(channel);
  if (layers.empty()) throw Error(ErrorKind::input, image_path.string() + ": no channel has the name of one in " + reference_path.string());
  for (auto& [name, sums] : layers) result.layers.push_back(sums.finish());
  return result;
}

}  // namespace relume
