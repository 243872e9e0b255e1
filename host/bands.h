// How a frame is cut into bands of rows: small ones, so that while one is shaded the next is decoded and the one before is encoded.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gbuffer/window.h"

namespace relume {

struct BandLimits {
  std::int64_t memory = 0;            ///< bytes for all bands in flight
  std::int64_t row_bytes = 0;         ///< of a row of pixels in all its planes, those read and those shaded
  std::int64_t most_rows = 0;         ///< in one band: what the device and 32-bit offsets hold
  std::int64_t good_pixels = 0;       ///< in a band: fewer are not worth the launch
  int block_top = 0, block_rows = 1;  ///< the file's blocks of rows: a band of whole ones decodes each once
};

struct Bands {
  std::vector<Window> windows;  ///< top to bottom
  int in_flight = 1;            ///< at once within the memory
  std::int64_t bytes = 0;       ///< of those in flight
};

/// Throws Error{memory} that begins with `place` where not even one row fits.
Bands bands_of(const Window& window, const BandLimits& limits, const std::string& place);

}  // namespace relume
