// What a question about a file is asked with: the file, a sample of its pixels, and what the user has said already.
#pragma once

#include <vector>

#include "gbuffer/reading.h"
#include "gbuffer/sample_rows.h"

namespace relume {

struct Asked {
  const ExrFile& file;
  const std::vector<SampledBand>& bands;  ///< of position, normal, base_normal, depth, coverage and ids, as far as the file has them
  const ReadingOptions& options;
};

}  // namespace relume
