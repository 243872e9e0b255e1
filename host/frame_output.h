// What becomes of a frame that was shaded: an EXR, and a PNG where one is wanted, band after band.
#pragma once

#include "gbuffer/gbuffer.h"
#include "gbuffer/picture.h"
#include "gbuffer/write_exr.h"
#include "host/output_layout.h"
#include "host/relight.h"

namespace relume {

/// The input's own alpha where it has one that is a number, else the coverage.
void write_alpha(const GBuffer& gbuffer, const Reading& reading, Planes& out);

class FrameOutput {
 public:
  /// Refuses outputs that exist before any work, as ExrWriter does. `job` and `layout` outlive it.
  FrameOutput(const RelightJob& job, const OutputLayout& layout, const Imf::Header& like, const Window& window, const Window& display_window,
              const std::vector<std::pair<std::string, std::string>>& metadata);

  /// The next band.
  void write(const Window& band, const Planes& planes);

  /// Both files are there, or neither.
  void commit();

 private:
  const RelightJob& job_;
  const OutputLayout& layout_;
  const Window window_;
  ExrWriter writer_;
  Picture picture_;  ///< empty where none is wanted
};

}  // namespace relume
