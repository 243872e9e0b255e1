// The attributes of an OpenEXR header as they lie in the file, read with 64-bit arithmetic and nothing allocated by a claimed size.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "gbuffer/error.h"
#include "gbuffer/input_stream.h"

namespace relume {

struct RawAttribute {
  std::string name, type;
  std::uint64_t position = 0;  ///< of its value in the file
  std::int64_t size = 0;       ///< bytes of its value, all within the file
};

using RawHeader = std::map<std::string, RawAttribute>;

/// Reads headers one after the other. Every function throws Error{input} where the file says what cannot be.
class HeaderReader {
 public:
  explicit HeaderReader(InputStream& file) : file_(file) {}

  /// The next header, its sizes and types checked; empty for the empty one that ends a multi-part file's list.
  RawHeader next();
  std::uint64_t position() const { return position_; }
  void seek(std::uint64_t position) { position_ = position; }
  void enter_part(int part) { part_ = part; }  ///< named in messages; -1: the file itself

  [[noreturn]] void refuse(const std::string& what, ErrorKind kind = ErrorKind::input) const;

  std::uint32_t word(std::uint64_t position);
  std::int64_t integer(std::uint64_t position) { return std::int32_t(word(position)); }
  int byte(std::uint64_t position);
  /// A zero-terminated text that must end before `end`; moves `position` past it.
  std::string text(std::uint64_t& position, std::uint64_t end, const char* what);
  /// The value of a `string` attribute, cut to 255 bytes.
  std::string value(const RawAttribute& attribute);

 private:
  void bytes(std::uint64_t position, void* data, std::size_t size);
  void check(const RawAttribute& attribute);
  void check_texts(const RawAttribute& attribute);
  bool is_preview(const RawAttribute& attribute);

  InputStream& file_;
  std::uint64_t position_ = 0;
  int part_ = -1, attributes_ = 0;
};

}  // namespace relume
