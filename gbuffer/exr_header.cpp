// Walks attributes: name, type, size, value (openexr.com, "OpenEXR File Layout").
#include "gbuffer/exr_header.h"

#include <algorithm>
#include <array>

#include "gbuffer/printable.h"

namespace relume {
namespace {

constexpr std::int64_t longest_name = 255;        // with the long-names flag; without it 31, but some writers forget the flag
constexpr int most_attributes = 100'000;          // of all parts: hundreds of parts with hundreds each
constexpr std::int64_t longest_value = 64 << 20;  // large tables and metadata fit; OpenEXR allocates this before it reads

/// Sizes that fixed-size types must have: OpenEXR reads them without looking at the declared size, and would then read another header than we.
const std::map<std::string, std::int64_t>& fixed_sizes() {
  static const std::map<std::string, std::int64_t> sizes = {{"box2f", 16},
                                                            {"box2i", 16},
                                                            {"chromaticities", 32},
                                                            {"compression", 1},
                                                            {"deepImageState", 1},
                                                            {"double", 8},
                                                            {"envmap", 1},
                                                            {"float", 4},
                                                            {"int", 4},
                                                            {"keycode", 28},
                                                            {"lineOrder", 1},
                                                            {"m33d", 72},
                                                            {"m33f", 36},
                                                            {"m44d", 128},
                                                            {"m44f", 64},
                                                            {"rational", 8},
                                                            {"tiledesc", 9},
                                                            {"timecode", 8},
                                                            {"v2d", 16},
                                                            {"v2f", 8},
                                                            {"v2i", 8},
                                                            {"v3d", 24},
                                                            {"v3f", 12},
                                                            {"v3i", 12}};
  return sizes;
}

/// The types that OpenEXR itself takes for granted.
const std::map<std::string, std::string>& known_types() {
  static const std::map<std::string, std::string> types = {
      {"channels", "chlist"},     {"compression", "compression"}, {"dataWindow", "box2i"}, {"displayWindow", "box2i"},
      {"lineOrder", "lineOrder"}, {"tiles", "tiledesc"},          {"type", "string"},      {"name", "string"},
      {"view", "string"},         {"chunkCount", "int"},          {"preview", "preview"},  {"multiView", "stringvector"},
      {"version", "int"},         {"pixelAspectRatio", "float"}};
  return types;
}

std::string number(std::int64_t value) { return std::to_string(value); }

std::string shown(const RawAttribute& attribute) { return "attribute \"" + printable(attribute.name) + '"'; }

}  // namespace

void HeaderReader::refuse(const std::string& what, ErrorKind kind) const {
  throw Error(kind, file_.name() + ": " + (part_ < 0 ? "" : "part " + number(part_) + ": ") + what);
}

void HeaderReader::bytes(std::uint64_t position, void* data, std::size_t size) {
  if (!file_.read_at(position, data, size)) refuse("header ends early");
}

std::uint32_t HeaderReader::word(std::uint64_t position) {
  std::array<unsigned char, 4> b{};
  bytes(position, b.data(), b.size());
  return std::uint32_t(b[0]) | std::uint32_t(b[1]) << 8 | std::uint32_t(b[2]) << 16 | std::uint32_t(b[3]) << 24;
}

int HeaderReader::byte(std::uint64_t position) {
  unsigned char b = 0;
  bytes(position, &b, 1);
  return b;
}

std::string HeaderReader::text(std::uint64_t& position, std::uint64_t end, const char* what) {
  std::string out;
  for (;;) {
    if (position >= end) refuse(std::string(what) + " without an end");
    const char c = char(byte(position++));
    if (c == 0) return out;
    out += c;
    if (std::int64_t(out.size()) > longest_name) refuse(std::string(what) + " longer than " + number(longest_name) + " bytes");
  }
}

std::string HeaderReader::value(const RawAttribute& attribute) {
  std::string value(std::size_t(std::min(attribute.size, longest_name)), ' ');
  bytes(attribute.position, value.data(), value.size());
  return value;
}

RawHeader HeaderReader::next() {
  RawHeader header;
  for (;;) {
    RawAttribute attribute;
    attribute.name = text(position_, file_.size(), "attribute name");
    if (attribute.name.empty()) return header;
    if (++attributes_ > most_attributes) refuse("more than " + number(most_attributes) + " attributes");
    attribute.type = text(position_, file_.size(), "attribute type");
    attribute.size = integer(position_);
    attribute.position = position_ + 4;
    const std::int64_t left = std::int64_t(file_.size() - attribute.position);
    if (attribute.size < 0 || attribute.size > left)
      refuse(shown(attribute) + " claims " + number(attribute.size) + " bytes of " + number(left) + " left in the file");
    check(attribute);
    position_ = attribute.position + std::uint64_t(attribute.size);
    if (!header.emplace(attribute.name, attribute).second) refuse(shown(attribute) + " appears twice");
  }
}

void HeaderReader::check(const RawAttribute& attribute) {
  if (attribute.size > longest_value) refuse(shown(attribute) + " has " + number(attribute.size) + " bytes (at most " + number(longest_value) + ")");
  // Its value is a zlib stream with sizes of its own, which the library trusts; only deep files need it.
  if (attribute.type == "idmanifest") refuse(shown(attribute) + " is an id manifest, which is not read");
  const auto known = known_types().find(attribute.name);
  if (known != known_types().end() && attribute.type != known->second)
    refuse(shown(attribute) + " has type \"" + printable(attribute.type) + "\" (must be " + known->second + ")");
  // The library reads a channel list to its own end, whatever size it declares; exr_guard.cpp checks that of the one that is needed.
  if (attribute.type == "chlist" && attribute.name != "channels") refuse(shown(attribute) + " is a channel list (only \"channels\" may be)");
  const auto fixed = fixed_sizes().find(attribute.type);
  if (fixed != fixed_sizes().end() && attribute.size != fixed->second)
    refuse(shown(attribute) + " has " + number(attribute.size) + " bytes (" + fixed->first + " has " + number(fixed->second) + ")");
  if (attribute.type == "floatvector" && attribute.size % 4 != 0) refuse(shown(attribute) + " is no list of floats");
  if (attribute.type == "stringvector") check_texts(attribute);
  if (attribute.type == "preview" && !is_preview(attribute)) refuse(shown(attribute) + " has another size than its picture needs");
}

void HeaderReader::check_texts(const RawAttribute& attribute) {
  for (std::int64_t at = 0; at < attribute.size;) {
    const std::int64_t length = attribute.size - at < 4 ? -1 : integer(attribute.position + std::uint64_t(at));
    at += 4;
    if (length < 0 || length > attribute.size - at) refuse(shown(attribute) + " is no list of texts");
    at += length;
  }
}

bool HeaderReader::is_preview(const RawAttribute& attribute) {
  if (attribute.size < 8) return false;
  const std::int64_t width = word(attribute.position), height = word(attribute.position + 4);
  return width <= longest_value && height <= longest_value && width * height * 4 == attribute.size - 8;
}

}  // namespace relume
