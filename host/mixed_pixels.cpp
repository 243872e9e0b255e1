// Mixed pixels, counted and folded.
#include "host/mixed_pixels.h"

#include <algorithm>
#include <cstdio>

namespace relume {

void MixedPixels::add(const Mixtures& mixtures) {
  apart_ += mixtures.apart;
  partial_ += mixtures.partial;
  unexplained_ += mixtures.unexplained;
}

std::string MixedPixels::sentence(std::int64_t surface_pixels) const {
  const std::int64_t mixed = apart_ + partial_ + unexplained_;
  if (mixed == 0) return {};
  char share[32];
  std::snprintf(share, sizeof share, "%.1f %%", 100.0 * double(mixed) / double(std::max<std::int64_t>(1, surface_pixels)));
  return std::to_string(mixed) + " of " + std::to_string(surface_pixels) + " pixels mix surfaces or background (" + share +
         "): " + std::to_string(apart_) + " shaded surface by surface, " + std::to_string(partial_) + " with one surface and background, " +
         std::to_string(unexplained_) + " unexplained and shaded as the mean (--edges as-stored shades all so)";
}

void fold_surfaces(const GBuffer& gbuffer, Planes& out) {
  const std::size_t pixels = std::size_t(gbuffer.window.pixels());
  for (int p = 0; p < out.count(); ++p)
    for (std::size_t k = 0; k < gbuffer.homes.size(); ++k) out.plane(p)[gbuffer.homes[k]] += out.plane(p)[pixels + k];
}

}  // namespace relume
