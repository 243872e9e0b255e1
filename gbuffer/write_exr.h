// An OpenEXR file to write: rows arrive in bands, the file appears whole under its name or not at all.
#pragma once

#include <ImfCompression.h>
#include <ImfHeader.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "gbuffer/exr_file.h"
#include "gbuffer/window.h"

namespace relume {

struct OutputFormat {
  SampleType type = SampleType::float32;
  std::string compression = "zip";  ///< a name of compression_names()
  bool overwrite = false;
};

/// none, rle, zips, zip, piz, pxr24, b44, b44a, dwaa, dwab.
const std::vector<std::string>& compression_names();
/// Error{input} that lists them for another.
Imf::Compression compression_named(const std::string& name);

/// Rows of one channel, float, ready to write.
struct Source {
  std::string channel;
  const float* first;    ///< first pixel of the band
  std::size_t x_stride;  ///< bytes
  std::size_t y_stride;  ///< bytes

  /// Row `y` of the band side by side: where it is, or in `gathered`.
  const float* row(int y, int width, std::vector<float>& gathered) const;
};

class ExrWriter {
 public:
  /// `like`: the input's header; its attributes are kept but for those that describe storage (channels, compression, tiles, parts, preview, ...).
  /// `metadata`: text attributes added. Refuses an existing `file` without overwrite, before any work: Error{output}.
  /// Writes to a hidden temporary beside `file`, removed on any failure and by interrupt (gbuffer/whole_file.h).
  ExrWriter(const std::filesystem::path& file, const OutputFormat& format, const Imf::Header& like, const Window& data_window,
            const Window& display_window, const std::vector<std::string>& channels, const std::vector<std::pair<std::string, std::string>>& metadata);
  ~ExrWriter();

  /// The next `rows` rows, top to bottom; one Source for each channel.
  void write_rows(int rows, std::span<const Source> sources);

  /// Ends the file: flush, fsync, re-open and verify, rename. Without this call nothing is left behind. Throws Error{output}.
  void commit();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace relume
