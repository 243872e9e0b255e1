// One surface of a mixed pixel, put into a band's planes in the form in which the file stores a pixel.
#pragma once

#include "gbuffer/gbuffer.h"

namespace relume {

/// `at`: the pixel, or a place after the window's pixels.
void place_sample(const Mixtures& mixtures, std::size_t sample, std::size_t at, const Reading& reading, GBuffer& gbuffer);

/// The pixels of those samples that have a place after the window's pixels.
std::vector<std::int64_t> homes_of(const Mixtures& mixtures);

}  // namespace relume
