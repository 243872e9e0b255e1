// A file that is whole or not there: a temporary in the same folder, fsync, rename; removed on failure and on SIGINT/SIGTERM.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace relume {

class WholeFile {
 public:
  /// Creates ".<name>.<pid>.tmp" beside `file`. Refuses an existing `file` unless `overwrite`; refuses what is no regular file. Error{output}.
  WholeFile(const std::filesystem::path& file, bool overwrite);
  ~WholeFile();  ///< removes the temporary unless commit() was called
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  /// Every byte or Error{output} ("disk full", ...), thrown here or, for bytes still buffered, by seek() or commit().
  void write(const void* data, std::size_t bytes);
  void seek(std::uint64_t position);
  std::uint64_t position() const;
  const std::filesystem::path& temporary() const;

  /// fsync, close, `verify(temporary)`, rename (never over a file that appeared meanwhile unless overwrite), fsync of the folder.
  void commit(const std::function<void(const std::filesystem::path&)>& verify = {});

 private:
  [[noreturn]] void fail(int code) const;
  void check_target();
  void create_temporary();
  void flush();
  void put_in_place();
  void discard() noexcept;

  std::filesystem::path file_, temporary_;
  std::string name_;  ///< the path as the user wrote it, printable
  bool overwrite_ = false;
  int descriptor_ = -1;
  int mode_ = 0666;             ///< of a file that is overwritten, else what umask leaves
  int slot_ = -1;               ///< where the temporary is noted for remove_temporaries()
  std::uint64_t position_ = 0;  ///< of the first buffered byte
  std::vector<char> buffer_;
};

/// A file of these bytes, whole or not there.
void write_whole(const std::filesystem::path& file, const std::string& bytes, bool overwrite);

/// For signal handlers: unlinks every temporary now open. Async-signal-safe.
void remove_temporaries() noexcept;

}  // namespace relume
