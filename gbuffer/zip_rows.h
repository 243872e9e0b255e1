// Rows of a scan-line part that is packed by ZIP or ZIPS, without OpenEXR's decoder: blocks are unpacked on all cores, and only the channels asked
// for are put together from their bytes.
#pragma once

#include <ImfInputPart.h>

#include <span>

#include "gbuffer/exr_file.h"

namespace relume {

/// Whether read_zip_rows() can: scan lines, ZIP or ZIPS, every channel at full resolution, to its own type or float.
bool reads_zip_rows(const Part& part, std::span<const Destination> destinations);

/// As ExrFile::read(), of destinations that name each channel once. `block_rows`: rows of a block; `threads`: blocks that may be in memory at once.
/// Throws what OpenEXR throws.
void read_zip_rows(const Imf::InputPart& input, const Part& part, const Window& window, std::span<const Destination> destinations, int block_rows,
                   int threads);

}  // namespace relume
