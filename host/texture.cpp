// Texture: EXR through our own reader, other formats through OpenImageIO; nearest or bilinear.
#include "host/texture.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <tuple>

#include "gbuffer/error.h"
#include "gbuffer/exr_file.h"

namespace relume {
namespace {

/// The root R G B, or the first three (or one) channels, of the first part.
Picture read_exr_picture(const std::filesystem::path& path) {
  const ExrFile file(path);
  const Part& part = file.parts().front();
  std::vector<std::string> channels;
  if (part.has_channel("R") && part.has_channel("G") && part.has_channel("B"))
    channels = {"R", "G", "B"};
  else
    for (const Channel& channel : part.channels)
      if (channels.size() < 3) channels.push_back(channel.name);
  if (channels.empty()) throw Error(ErrorKind::input, path.string() + ": a texture without channels");
  Picture picture{part.data_window.width(), part.data_window.height(), int(channels.size()), {}};
  picture.values.resize(std::size_t(part.data_window.pixels()) * channels.size());
  std::vector<Destination> destinations;
  const std::size_t pixel = channels.size() * sizeof(float);
  for (std::size_t c = 0; c < channels.size(); ++c)
    destinations.push_back({channels[c], SampleType::float32, &picture.values[c], pixel, pixel * std::size_t(picture.width)});
  file.read(0, part.data_window, destinations);
  return picture;
}

/// i modulo n, never negative.
long wrapped(long i, long n) { return ((i % n) + n) % n; }

}  // namespace

Texture::Texture(const TextureValue& value)
    : picture_(value.file.extension() == ".exr" ? read_exr_picture(value.file) : read_picture(value.file)),
      bilinear_(value.bilinear),
      v_down_(value.v_down) {}

double Texture::texel(long x, long y, int c) const {
  const long column = wrapped(x, picture_.width), row = wrapped(y, picture_.height);
  return picture_.values[std::size_t((row * picture_.width + column) * picture_.channels + std::min(c, picture_.channels - 1))];
}

double Texture::sample(double u, double v, int c) const {
  if (!std::isfinite(u) || !std::isfinite(v)) return 0;
  const double x = u * picture_.width, y = (v_down_ ? v : 1 - v) * picture_.height;
  if (!bilinear_) return texel(long(std::floor(x)), long(std::floor(y)), c);
  const double left = std::floor(x - 0.5), top = std::floor(y - 0.5), fx = x - 0.5 - left, fy = y - 0.5 - top;
  const long i = long(left), j = long(top);
  return (texel(i, j, c) * (1 - fx) + texel(i + 1, j, c) * fx) * (1 - fy) + (texel(i, j + 1, c) * (1 - fx) + texel(i + 1, j + 1, c) * fx) * fy;
}

const Texture& texture_of(const TextureValue& value) {
  static std::mutex mutex;
  static std::map<std::tuple<std::string, bool, bool>, Texture> textures;
  const std::lock_guard lock(mutex);
  const auto key = std::tuple(value.file.string(), value.bilinear, value.v_down);
  const auto found = textures.find(key);
  return found != textures.end() ? found->second : textures.emplace(key, Texture(value)).first->second;
}

}  // namespace relume
