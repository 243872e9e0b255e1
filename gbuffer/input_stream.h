// A regular file to read from at any position, for our header scan and for OpenEXR alike: both see the same open file.
#pragma once

#include <ImfIO.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace relume {

class InputStream : public Imf::IStream {
 public:
  /// Refuses what is no regular file (a FIFO would hang, a device never ends). Throws Error{input}.
  explicit InputStream(const std::filesystem::path& file);
  ~InputStream() override;

  /// Every byte, or false at the end of the file. Throws Error{input} on a read error.
  bool read_at(std::uint64_t position, void* data, std::size_t bytes);
  std::uint64_t size() const { return size_; }
  const std::string& name() const { return name_; }  ///< the path, printable

  bool read(char data[], int bytes) override;
  std::uint64_t tellg() override { return position_; }
  void seekg(std::uint64_t position) override { position_ = position; }

 private:
  bool read_through(std::uint64_t position, char* data, std::size_t bytes);

  std::string name_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0, position_ = 0;
  std::vector<char> buffer_;  ///< headers are read byte by byte: one system call for many
  std::uint64_t buffer_start_ = 0;
};

}  // namespace relume
