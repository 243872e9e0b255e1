// What the headers mean: channels, windows, tiles and chunk tables, each against the file's size and the limits.
#include "gbuffer/exr_guard.h"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <vector>

#include "gbuffer/exr_header.h"
#include "gbuffer/printable.h"

namespace relume {
namespace {

constexpr std::uint32_t magic = 20000630;
constexpr std::uint32_t flag_tiled = 0x200, flag_long_names = 0x400, flag_deep = 0x800, flag_parts = 0x1000;
constexpr std::int64_t farthest = 1 << 29;   // window corners: sums and differences of two stay within int
constexpr std::int64_t largest_tile = 4096;  // a side

std::string number(std::int64_t value) { return std::to_string(value); }

struct Box {
  std::int64_t min_x = 0, min_y = 0, max_x = -1, max_y = -1;  ///< inclusive, as in the file
  std::int64_t width() const { return max_x - min_x + 1; }
  std::int64_t height() const { return max_y - min_y + 1; }
};

struct PartScan {
  RawHeader attributes;
  std::int64_t pixel_bytes = 0;  ///< all channels, as if none were subsampled: an upper bound
  Box data;
  int compression = 0;
};

class Guard {
 public:
  Guard(InputStream& file, const ReadLimits& limits) : file_(file), read_(file), limits_(limits) {}
  std::int64_t run();

 private:
  void check_version();
  void check_type(const PartScan& part);
  void check_channels(PartScan& part);
  void check_windows(PartScan& part);
  void check_codes(PartScan& part);
  std::int64_t chunks(const PartScan& part);
  std::int64_t tiles(const PartScan& part);
  void note_block(const PartScan& part, std::int64_t pixels, const char* what);
  Box box(const RawAttribute& attribute);
  const RawAttribute& required(const PartScan& part, const char* name);

  InputStream& file_;
  HeaderReader read_;
  const ReadLimits& limits_;
  bool tiled_ = false, multi_part_ = false;  ///< the flags
  std::int64_t block_bytes_ = 0;             ///< the largest
};

std::int64_t Guard::run() {
  check_version();
  read_.seek(8);
  std::int64_t table = 0;
  for (int i = 0;; ++i) {
    if (multi_part_) read_.enter_part(i);
    PartScan part;
    part.attributes = read_.next();
    if (part.attributes.empty() && i == 0) read_.refuse("empty header");
    if (part.attributes.empty()) break;
    if (i == limits_.max_parts) read_.refuse("more than " + number(limits_.max_parts) + " parts (ReadLimits::max_parts)");
    check_type(part);
    check_channels(part);
    check_codes(part);
    check_windows(part);
    table += chunks(part);
    if (!multi_part_) break;
  }
  read_.enter_part(-1);
  // Each chunk has 8 bytes in the table after the headers, and the library allocates the table first.
  const std::int64_t left = std::int64_t(file_.size() - read_.position());
  if (table > left / 8) read_.refuse(number(table) + " chunks need a table of 8 bytes each, " + number(left) + " bytes are left in the file");
  return block_bytes_;
}

void Guard::check_version() {
  if (file_.size() < 8 || read_.word(0) != magic) read_.refuse("not an OpenEXR file");
  const std::uint32_t version = read_.word(4), flags = version & ~0xffu;
  if ((version & 0xff) != 2) read_.refuse("OpenEXR version " + number(version & 0xff) + " (only 2 is read)");
  if (flags & ~(flag_tiled | flag_long_names | flag_deep | flag_parts)) read_.refuse("unknown flags in the version field");
  if (flags & flag_deep) read_.refuse("deep pixels are not read");
  tiled_ = flags & flag_tiled;
  multi_part_ = flags & flag_parts;
  if (tiled_ && multi_part_) read_.refuse("flags of a single tiled part and of several parts contradict each other");
}

const RawAttribute& Guard::required(const PartScan& part, const char* name) {
  const auto found = part.attributes.find(name);
  if (found == part.attributes.end()) read_.refuse(std::string("no attribute \"") + name + "\", which every such part needs");
  return found->second;
}

void Guard::check_type(const PartScan& part) {
  const auto found = part.attributes.find("type");
  const std::string type = found == part.attributes.end() ? "" : read_.value(found->second);
  if (type == "deepscanline" || type == "deeptile") read_.refuse("deep pixels are not read");
  if (multi_part_) required(part, "type");
  const bool known = type == "scanlineimage" || type == "tiledimage" || (type.empty() && !multi_part_);
  if (!known) read_.refuse("type \"" + printable(type) + "\" is not known (scanlineimage, tiledimage)");
}

void Guard::check_channels(PartScan& part) {
  const RawAttribute& list = required(part, "channels");
  std::uint64_t at = list.position;
  const std::uint64_t end = list.position + std::uint64_t(list.size);
  std::string previous;
  for (int count = 0;; ++count) {
    const std::string name = read_.text(at, end, "channel name");
    if (name.empty()) break;
    const std::string shown = "channel \"" + printable(name) + '"';
    if (count == limits_.max_channels) read_.refuse("more than " + number(limits_.max_channels) + " channels (ReadLimits::max_channels)");
    if (end - at < 16) read_.refuse("channel list ends early");
    const std::int64_t type = read_.integer(at), x_sampling = read_.integer(at + 8), y_sampling = read_.integer(at + 12);
    if (type < 0 || type > 2) read_.refuse(shown + " has pixel type " + number(type) + " (0 uint, 1 half, 2 float)");
    if (std::min(x_sampling, y_sampling) < 1 || std::max(x_sampling, y_sampling) > limits_.max_side)
      read_.refuse(shown + " has sampling " + number(x_sampling) + "x" + number(y_sampling));
    // The library's list is sorted and holds a name once: in another order it and the file would disagree on which bytes are whose.
    if (count > 0 && name <= previous) read_.refuse(shown + " is out of order or appears twice");
    previous = name;
    part.pixel_bytes += type == 1 ? 2 : 4;
    at += 16;
  }
  if (at != end) read_.refuse("channel list has " + number(std::int64_t(end - at)) + " bytes after its end");
  if (part.pixel_bytes == 0) read_.refuse("no channels");
}

void Guard::check_codes(PartScan& part) {
  part.compression = read_.byte(required(part, "compression").position);
  if (part.compression > 9) read_.refuse("compression " + number(part.compression) + " is not known (0 to 9)");
  const int order = read_.byte(required(part, "lineOrder").position);
  if (order > 2) read_.refuse("line order " + number(order) + " is not known (0 to 2)");
  const float aspect = std::bit_cast<float>(read_.word(required(part, "pixelAspectRatio").position));
  if (!(aspect >= 1e-6f && aspect <= 1e6f)) read_.refuse("pixelAspectRatio is not between 1e-6 and 1e6");  // OpenEXR's own bounds
}

Box Guard::box(const RawAttribute& attribute) {
  const std::uint64_t at = attribute.position;
  const Box box{read_.integer(at), read_.integer(at + 4), read_.integer(at + 8), read_.integer(at + 12)};
  const auto [least, most] = std::minmax({box.min_x, box.min_y, box.max_x, box.max_y});
  if (least < -farthest || most > farthest) read_.refuse(attribute.name + " lies beyond " + number(farthest) + " pixels");
  if (box.width() < 1 || box.height() < 1) read_.refuse(attribute.name + " is empty or inverted");
  return box;
}

void Guard::check_windows(PartScan& part) {
  box(required(part, "displayWindow"));
  part.data = box(required(part, "dataWindow"));
  const std::int64_t width = part.data.width(), height = part.data.height();
  const std::string size = number(width) + " x " + number(height) + " pixels";
  if (std::max(width, height) > limits_.max_side)
    read_.refuse("dataWindow has " + size + " (a side at most " + number(limits_.max_side) + ": ReadLimits::max_side)");
  if (width * height > limits_.max_decoded_bytes / part.pixel_bytes)
    read_.refuse(
        size + " of " + number(part.pixel_bytes) + " bytes exceed " + number(limits_.max_decoded_bytes) + " bytes (ReadLimits::max_decoded_bytes)",
        ErrorKind::memory);
}

std::int64_t Guard::chunks(const PartScan& part) {
  constexpr std::array<int, 10> block_rows = {1, 1, 1, 16, 32, 16, 32, 32, 32, 256};  // none rle zips zip piz pxr24 b44 b44a dwaa dwab
  const bool tiled = multi_part_ ? read_.value(required(part, "type")) == "tiledimage" : tiled_;
  std::int64_t count = 0;
  if (tiled || part.attributes.contains("tiles")) count = tiles(part);
  if (!tiled) {
    const std::int64_t rows = block_rows[std::size_t(part.compression)];
    note_block(part, part.data.width() * rows, "a block of rows");
    count = (part.data.height() + rows - 1) / rows;
  }
  const auto declared = part.attributes.find("chunkCount");
  const std::int64_t said = declared == part.attributes.end() ? count : read_.integer(declared->second.position);
  if (said != count) read_.refuse("chunkCount says " + number(said) + ", size and compression say " + number(count));
  return count;
}

void Guard::note_block(const PartScan& part, std::int64_t pixels, const char* what) {
  constexpr std::int64_t counted = (1LL << 31) - 1;  // OpenEXR's decoders count a block's bytes in int (CVE-2026-34588)
  const std::int64_t most = std::min(limits_.max_block_bytes, counted);
  if (pixels > most / part.pixel_bytes)
    read_.refuse(std::string(what) + " decodes to " + number(pixels * part.pixel_bytes) + " bytes (at most " + number(most) +
                     ": ReadLimits::max_block_bytes; codecs with blocks of fewer rows need less: zip, zips)",
                 ErrorKind::memory);
  block_bytes_ = std::max(block_bytes_, pixels * part.pixel_bytes);
}

/// How many tiles all levels have.
std::int64_t Guard::tiles(const PartScan& part) {
  const RawAttribute& description = required(part, "tiles");
  const std::int64_t width = read_.word(description.position), height = read_.word(description.position + 4);
  if (std::min(width, height) < 1 || std::max(width, height) > largest_tile)
    read_.refuse("tiles of " + number(width) + " x " + number(height) + " pixels (a side 1 to " + number(largest_tile) + ")");
  note_block(part, width * height, "a tile");
  enum { one_level, mip_levels, rip_levels };
  const int mode = read_.byte(description.position + 8), levels = mode & 0xf, rounding = mode >> 4;
  if (levels > rip_levels || rounding > 1) read_.refuse("tile levels " + number(mode) + " are not known");

  const auto tiles_by_level = [&](std::int64_t side, std::int64_t tile) {
    std::vector<std::int64_t> counts{(side + tile - 1) / tile};
    while (levels != one_level && side > 1) {
      side = (side + rounding) / 2;
      counts.push_back((side + tile - 1) / tile);
    }
    return counts;
  };
  std::vector<std::int64_t> columns = tiles_by_level(part.data.width(), width), rows = tiles_by_level(part.data.height(), height);
  if (levels == rip_levels)  // every width with every height
    return std::accumulate(columns.begin(), columns.end(), std::int64_t(0)) * std::accumulate(rows.begin(), rows.end(), std::int64_t(0));
  columns.resize(std::max(columns.size(), rows.size()), 1);  // the shorter side stays one pixel
  rows.resize(columns.size(), 1);
  return std::inner_product(columns.begin(), columns.end(), rows.begin(), std::int64_t(0));
}

}  // namespace

std::int64_t check_headers(InputStream& file, const ReadLimits& limits) { return Guard(file, limits).run(); }

}  // namespace relume
