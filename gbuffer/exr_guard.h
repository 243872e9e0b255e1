// The gate before OpenEXR: every number in the headers is checked against the file's size and our limits, so that a few bytes
// cannot ask the library for gigabytes or for a decoder that Debian's version has open faults in (research: reliability, sections 1 and 2).
#pragma once

#include "gbuffer/exr_file.h"
#include "gbuffer/input_stream.h"

namespace relume {

/// Bytes of the largest block of rows, or tile, that is decoded at once. Throws Error{input}, or Error{memory} where only `max_decoded_bytes` stands
/// against the file.
std::int64_t check_headers(InputStream& file, const ReadLimits& limits);

}  // namespace relume
