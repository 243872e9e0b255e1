// MeshRadiance: lists in memory, gathered by each pixel's triangle and barycentric weights. The weights are the surface's own, not the screen's:
// perspective is kept, which Gouraud's hardware did not.
#include "host/interpolation.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "gbuffer/error.h"
#include "gbuffer/mesh_parts.h"
#include "gbuffer/printable.h"

namespace relume {
namespace {

template <class Value>
std::vector<Value> channel_of(const ExrFile& file, const Part& part, const Window& window, const std::string& channel, SampleType type) {
  if (!part.has_channel(channel))
    throw Error(ErrorKind::input, printable(file.path().native()) + ": part " + std::to_string(part.index) + " has no channel \"" + channel +
                                      "\" (relume bake writes it; --interpolation phong needs none)");
  std::vector<Value> values(std::size_t(window.pixels()));
  const Destination to{channel, type, values.data(), sizeof(Value), sizeof(Value) * std::size_t(window.width())};
  file.read(part.index, window, {&to, 1});
  return values;
}

}  // namespace

MeshRadiance::MeshRadiance(const ExrFile& file, const Reading& pixels, Interpolation interpolation, const OutputLayout& layout, std::int64_t memory)
    : file_(file),
      interpolation_(interpolation),
      layout_(layout),
      pixels_part_(pixels.part),
      reading_(reading_of_part(pixels, file, mesh_part(file, interpolation == Interpolation::flat ? facets_part : vertices_part))) {
  const std::int64_t samples = reading_.data_window.pixels(),
                     facets = interpolation == Interpolation::gouraud ? mesh_part(file, facets_part).data_window.pixels() : 0;
  const std::int64_t bytes = (samples * layout.planes() + 3 * facets) * std::int64_t(sizeof(float));
  if (bytes > memory)
    throw Error(ErrorKind::memory, printable(file.path().native()) + ": the radiance of " + std::to_string(samples) + " samples of the mesh needs " +
                                       std::to_string(bytes) + " bytes; --memory allows " + std::to_string(memory));
  radiance_.assign(std::size_t(layout.planes()), std::vector<float>(std::size_t(samples)));
  if (interpolation == Interpolation::gouraud) read_facets();
}

void MeshRadiance::read_facets() {
  const Part& part = mesh_part(file_, facets_part);
  facets_.resize(3 * std::size_t(part.data_window.pixels()));
  for (std::size_t k = 0; k < 3; ++k) {
    const auto numbers = channel_of<std::uint32_t>(file_, part, part.data_window, facet_vertex_channels[k], SampleType::uint32);
    for (std::size_t i = 0; i < numbers.size(); ++i) facets_[3 * i + k] = checked(numbers[i], radiance_.front().size(), "vertex");
  }
}

std::uint32_t MeshRadiance::checked(std::uint32_t number, std::size_t count, const char* what) const {
  if (number < count) return number;
  throw Error(ErrorKind::input, printable(file_.path().native()) + ": a number of a " + what + " is " + std::to_string(number) +
                                    ", beyond the list of " + std::to_string(count));
}

void MeshRadiance::take(const Window& band, const Planes& lit) {
  const Window& whole = reading_.data_window;
  const std::size_t first = std::size_t(band.min_y - whole.min_y) * std::size_t(whole.width());
  for (std::size_t p = 0; p < radiance_.size(); ++p) std::copy_n(lit.plane(int(p)), band.pixels(), radiance_[p].data() + first);
}

void MeshRadiance::interpolate(const GBuffer& gbuffer, Planes& out) const {
  const Part& part = file_.parts()[std::size_t(pixels_part_)];
  const auto numbers = channel_of<std::uint32_t>(file_, part, gbuffer.window, facet_channel, SampleType::uint32);
  const auto second = channel_of<float>(file_, part, gbuffer.window, second_weight_channel, SampleType::float32);
  const auto third = channel_of<float>(file_, part, gbuffer.window, third_weight_channel, SampleType::float32);
  const float* const coverage = gbuffer.planes.plane(gbuffer.coverage.first);
  const bool flat = interpolation_ == Interpolation::flat;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, numbers.size()), [&](const tbb::blocked_range<std::size_t>& some) {
    for (std::size_t i = some.begin(); i < some.end(); ++i) {
      if (!(coverage[i] > 0)) continue;
      const std::size_t facet = checked(numbers[i], flat ? radiance_.front().size() : facets_.size() / 3, "facet");
      for (int p = 0; p < layout_.planes(); ++p) {
        if (p == OutputLayout::alpha) continue;
        const std::vector<float>& list = radiance_[std::size_t(p)];
        const auto at = [&](std::size_t k) { return list[facets_[3 * facet + k]]; };
        out.plane(p)[i] = flat ? list[facet] : (1 - second[i] - third[i]) * at(0) + second[i] * at(1) + third[i] * at(2);
      }
    }
  });
}

}  // namespace relume
