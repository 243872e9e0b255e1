// An OpenEXR file to read from: its parts and channels, and rows of chosen channels decoded straight into memory.
// The header is checked by our own scan before any library code sees the file (gbuffer/exr_guard.h).
#pragma once

#include <ImfHeader.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gbuffer/window.h"

namespace relume {

enum class SampleType { half_float, float32, uint32 };

/// "half", "float", "uint": OpenEXR's own names.
const char* name_of(SampleType type);

struct Channel {
  std::string name;  ///< as in the file: "ViewLayer.Normal.X"
  SampleType type;
};

struct Part {
  int index = 0;
  std::string name;  ///< empty in a single-part file that names none
  std::string view;  ///< the `view` attribute: "left"; empty where there is none
  Window data_window, display_window;
  std::vector<Channel> channels;
  Imf::Header header;  ///< every attribute, for conventions, cameras and copies

  bool has_channel(const std::string& channel) const;
};

/// What a file may ask of us; beyond it Error{input} or Error{memory} says which limit and how to raise it.
struct ReadLimits {
  std::int64_t max_decoded_bytes = std::int64_t(64) << 30;  ///< all channels of the largest part
  int max_side = 1 << 20;                                   ///< width or height, pixels
  std::int64_t max_block_bytes = std::int64_t(512) << 20;   ///< a block of rows or a tile, which is decoded in one piece
  int max_parts = 256;
  int max_channels = 1024;  ///< in one part
};

/// Where one channel's rows go. Samples are converted to `type` by OpenEXR (half -> float, uint stays uint when asked as uint32).
struct Destination {
  std::string channel;
  SampleType type;
  void* first;           ///< the sample of the first pixel of the window asked for
  std::size_t x_stride;  ///< bytes from a pixel to its right neighbour
  std::size_t y_stride;  ///< bytes from a row to the next
};

class ExrFile {
 public:
  /// Opens and checks the header. Throws Error{input} naming the file, part and channel.
  explicit ExrFile(const std::filesystem::path& file, const ReadLimits& limits = {});
  ~ExrFile();
  ExrFile(ExrFile&&) noexcept;

  const std::filesystem::path& path() const;
  const std::vector<Part>& parts() const;
  /// File-wide: the multiView attribute's names, first is the default view; empty if there is none.
  const std::vector<std::string>& views() const;

  /// Rows that are packed together, counted from the top of the part's data window: windows of whole blocks decode each once.
  int rows_in_block(int part) const;

  /// While OpenEXR decodes, the whole process may take only so much memory: how much of it is for what other threads do meanwhile.
  void leave_room(std::int64_t bytes);

  /// Decodes the window of one part, which must lie inside its data window; scan-line or tiled alike. From any thread.
  void read(int part, const Window& window, std::span<const Destination> destinations) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Attributes by name, compared without regard to case; empty optional where absent or of another type.
std::optional<std::string> text_attribute(const Imf::Header& header, const std::string& name);
/// 16 numbers in storage order, from an m44f/m44d attribute.
std::optional<std::vector<double>> matrix_attribute(const Imf::Header& header, const std::string& name);
/// Names of all attributes.
std::vector<std::string> attribute_names(const Imf::Header& header);

}  // namespace relume
