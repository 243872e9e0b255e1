// A file of our own in the folder for temporary ones, for what only takes files; gone with this object, and after a crash or an interrupt.
#pragma once

#include <filesystem>
#include <string>

namespace relume {

class TemporaryFile {
 public:
  /// Empty, with a name that ends so (".png"). Error{output}.
  explicit TemporaryFile(const std::string& ending);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int slot_ = -1;  ///< where it is noted for whoever tidies up
};

}  // namespace relume
