// An OpenEXR file of several parts, each with a data window and channels of its own: rows arrive in bands, the file appears whole or not at all.
#pragma once

#include <ImfHeader.h>

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "gbuffer/exr_file.h"
#include "gbuffer/window.h"

namespace relume {

struct OutputPart {
  std::string name;
  Window window;  ///< data window
  std::vector<Channel> channels;
  Imf::Header attributes;  ///< those of the file and the camera; windows, channels and codec are set here
};

class PartsWriter {
 public:
  /// Refuses an existing `file` without overwrite, before any work: Error{output}.
  PartsWriter(const std::filesystem::path& file, const std::string& compression, bool overwrite, const Window& display,
              const std::vector<OutputPart>& parts);
  ~PartsWriter();

  /// The next rows of a part, top to bottom: for each of its channels, in its order, samples side by side; floats, or 32-bit integers where the
  /// channel is uint. Those of half channels are rounded here.
  void write_rows(std::size_t part, int rows, std::span<const void* const> samples);

  /// Ends the file; without this call nothing is left behind. Error{output}.
  void commit();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace relume
