// read_environment: an image file's texels.
#include <ImfEnvmapAttribute.h>

#include <algorithm>
#include <optional>

#include "gbuffer/error.h"
#include "gbuffer/exr_file.h"
#include "gbuffer/picture.h"
#include "gbuffer/printable.h"
#include "host/environment_map.h"
#include "host/json.h"

namespace relume {
namespace {

bool is_exr(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return ending == ".exr";
}

/// The root's R, G, B; else the first layer's that has them; else a single channel for all three.
std::array<std::string, 3> colour_channels(const Part& part, const std::string& place) {
  std::vector<std::string> layers{""};
  for (const Channel& channel : part.channels)
    if (channel.name.ends_with(".R")) layers.push_back(channel.name.substr(0, channel.name.size() - 1));
  for (const std::string& layer : layers)
    if (part.has_channel(layer + "R") && part.has_channel(layer + "G") && part.has_channel(layer + "B"))
      return {layer + "R", layer + "G", layer + "B"};
  if (part.channels.size() != 1) throw Error(ErrorKind::input, place + ": an environment has channels R, G, B, or one channel");
  return {part.channels[0].name, part.channels[0].name, part.channels[0].name};
}

Picture read_exr(const std::filesystem::path& path) {
  const ExrFile file(path);
  const Part& part = file.parts().front();
  const auto* envmap = part.header.findTypedAttribute<Imf::EnvmapAttribute>("envmap");
  if (envmap && envmap->value() == Imf::ENVMAP_CUBE)
    throw Error(ErrorKind::input,
                printable(path.native()) + ": is a cube's six faces (envmap says so; exrenvmap -latlong makes a latitude-longitude image)");
  Picture picture{part.data_window.width(), part.data_window.height(), 3, {}};
  picture.values.resize(std::size_t(part.data_window.pixels()) * 3);
  constexpr std::size_t texel = 3 * sizeof(float);
  const std::array<std::string, 3> channels = colour_channels(part, printable(path.native()));
  for (std::size_t c = 0; c < 3; ++c) {  // one by one: a grey map's one channel goes three ways
    const Destination destination{channels[c], SampleType::float32, &picture.values[c], texel, texel * std::size_t(picture.width)};
    file.read(part.index, part.data_window, {&destination, 1});
  }
  return picture;
}

}  // namespace

EnvironmentMap read_environment(const std::filesystem::path& file, const EnvironmentMapping& mapping) {
  const Picture picture = is_exr(file) ? read_exr(file) : read_picture(file);
  const std::size_t channels = std::size_t(picture.channels), colour = channels < 3 ? 0 : 1;
  std::vector<std::array<float, 3>> radiance(std::size_t(picture.width) * std::size_t(picture.height));
  for (std::size_t i = 0; i < radiance.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) radiance[i][c] = picture.values[i * channels + c * colour];
  return environment_of(picture.width, picture.height, std::move(radiance), mapping, printable(file.native()));
}

}  // namespace relume
