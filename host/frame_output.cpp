// FrameOutput: planes to channels, and to the picture's pixels.
#include "host/frame_output.h"

#include <cmath>

namespace relume {

void write_alpha(const GBuffer& gbuffer, const Reading& reading, Planes& out) {
  const auto stored = gbuffer.roles.find("coverage");
  const PlaneRange from = stored != gbuffer.roles.end() && !reading.position_premultiplied ? stored->second : gbuffer.coverage;
  const float *alpha = gbuffer.planes.plane(from.first), *coverage = gbuffer.planes.plane(gbuffer.coverage.first);
  for (std::int64_t i = 0; i < gbuffer.samples(); ++i) out.plane(OutputLayout::alpha)[i] = std::isfinite(alpha[i]) ? alpha[i] : coverage[i];
}

FrameOutput::FrameOutput(const RelightJob& job, const OutputLayout& layout, const Imf::Header& like, const Window& window,
                         const Window& display_window, const std::vector<std::pair<std::string, std::string>>& metadata)
    : job_(job), layout_(layout), window_(window), writer_(job.output, job.format, like, window, display_window, layout.channels, metadata) {
  if (job_.png) picture_ = {window_.width(), window_.height(), 4, std::vector<float>(std::size_t(window_.pixels()) * 4)};
}

void FrameOutput::write(const Window& band, const Planes& planes) {
  std::vector<Source> sources;
  for (int p = 0; p < layout_.planes(); ++p)
    sources.push_back({layout_.channels[std::size_t(p)], planes.plane(p), sizeof(float), sizeof(float) * std::size_t(window_.width())});
  writer_.write_rows(band.height(), sources);
  if (!job_.png) return;
  const std::int64_t begin = std::int64_t(band.min_y - window_.min_y) * window_.width();
  for (std::int64_t i = 0; i < band.pixels(); ++i)
    for (int c = 0; c < 4; ++c) picture_.values[std::size_t(4 * (begin + i) + c)] = planes.plane(c)[i];
}

void FrameOutput::commit() {
  // The picture first: where it cannot be written, the image is not either.
  if (job_.png) write_png(*job_.png, picture_, job_.exposure, job_.format.overwrite);
  writer_.commit();
}

}  // namespace relume
