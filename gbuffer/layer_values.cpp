// Reading a layer with its components interleaved.
#include "gbuffer/layer_values.h"

namespace relume {

std::vector<float> layer_values(const ExrFile& file, const RoleLayer& layer, const Window& window) {
  const std::size_t components = layer.channels.size(), step = components * sizeof(float);
  std::vector<float> values(std::size_t(window.pixels()) * components);
  std::vector<Destination> destinations;
  for (std::size_t c = 0; c < components; ++c)
    destinations.push_back({layer.channels[c], SampleType::float32, values.data() + c, step, step * std::size_t(window.width())});
  file.read(layer.part, window, destinations);
  return values;
}

}  // namespace relume
