// lit: relight() to a temporary file and back, so that a figure shows what relume shade writes.
#include "cli/figures/lit_images.h"

#include "gbuffer/error.h"
#include "gbuffer/exr_file.h"
#include "gbuffer/mesh_parts.h"
#include "gbuffer/printable.h"
#include "gbuffer/temporary_file.h"
#include "host/relight.h"

namespace relume {
namespace {

template <class Value>
Destination whole(const std::string& channel, SampleType type, std::vector<Value>& to, const Window& window) {
  to.resize(std::size_t(window.pixels()));
  return {channel, type, to.data(), sizeof(Value), sizeof(Value) * std::size_t(window.width())};
}

}  // namespace

LitImage lit(const std::filesystem::path& gbuffer, Interpolation interpolation, const Lighting& lighting) {
  const TemporaryFile file(".exr");
  RelightJob job;
  job.gbuffer = gbuffer;
  job.output = file.path();
  job.rigs = lighting.rigs;
  job.material = lighting.material;
  job.device = lighting.device;
  job.interpolation = interpolation;
  job.format.overwrite = true;
  relight(job, {});
  const ExrFile image(file.path());
  const Window& window = image.parts().front().data_window;
  LitImage result{window.width(), window.height(), {}};
  std::vector<Destination> all;
  for (std::size_t c = 0; c < 3; ++c) all.push_back(whole(std::string(1, "RGB"[c]), SampleType::float32, result.rgb[c], window));
  image.read(0, window, all);
  return result;
}

std::vector<std::int64_t> facets_of(const std::filesystem::path& gbuffer) {
  const ExrFile file(gbuffer);
  const Part& part = file.parts().front();
  if (!part.has_channel(facet_channel) || !part.has_channel("A"))
    throw Error(ErrorKind::input,
                printable(gbuffer.native()) + ": tells no facets (a figure of interpolation wants a mesh, or what relume bake made of one)");
  std::vector<std::uint32_t> numbers;
  std::vector<float> coverage;
  const std::vector<Destination> all{whole(facet_channel, SampleType::uint32, numbers, part.data_window),
                                     whole("A", SampleType::float32, coverage, part.data_window)};
  file.read(0, part.data_window, all);
  std::vector<std::int64_t> facets(numbers.begin(), numbers.end());
  for (std::size_t i = 0; i < facets.size(); ++i)
    if (!(coverage[i] > 0)) facets[i] = -1;
  return facets;
}

}  // namespace relume
