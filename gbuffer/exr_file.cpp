// Reads through OpenEXR's multi-part interface, which serves scan-line and tiled parts alike.
#include "gbuffer/exr_file.h"

#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfPartType.h>
#include <ImfStandardAttributes.h>
#include <ImfThreading.h>

#include <strings.h>
#include <algorithm>

#include <cstring>
#include <mutex>
#include <new>
#include <set>
#include <thread>

#include "gbuffer/allowance.h"
#include "gbuffer/error.h"
#include "gbuffer/exr_guard.h"
#include "gbuffer/input_stream.h"
#include "gbuffer/printable.h"
#include "gbuffer/watched.h"
#include "gbuffer/zip_rows.h"

namespace relume {
namespace {

/// Half-open from OpenEXR's inclusive box.
Window window_of(const Imath::Box2i& box) { return {box.min.x, box.min.y, box.max.x + 1, box.max.y + 1}; }

SampleType sample_type(Imf::PixelType type) {
  if (type == Imf::HALF) return SampleType::half_float;
  return type == Imf::FLOAT ? SampleType::float32 : SampleType::uint32;
}

Imf::PixelType pixel_type(SampleType type) {
  if (type == SampleType::half_float) return Imf::HALF;
  return type == SampleType::float32 ? Imf::FLOAT : Imf::UINT;
}

std::size_t sample_bytes(SampleType type) { return type == SampleType::half_float ? 2 : 4; }

bool subsampled(const Imf::Channel& channel) { return channel.xSampling != 1 || channel.ySampling != 1; }

Part describe(int index, const Imf::Header& header) {
  Part part{index, "", "", window_of(header.dataWindow()), window_of(header.displayWindow()), {}, header};
  if (header.hasName()) part.name = header.name();
  if (header.hasView()) part.view = header.view();
  for (auto i = header.channels().begin(); i != header.channels().end(); ++i)
    if (!subsampled(i.channel())) part.channels.push_back({i.name(), sample_type(i.channel().type)});
  return part;
}

/// OpenEXR begins with 'Error reading pixel data from image file "shot.exr". ', once or twice, which our line has said already.
std::string cause(const char* message) {
  const char* const end = std::strstr(message, "image file ") ? std::strstr(message, "\". ") : nullptr;
  return end ? cause(end + 3) : printable(message);
}

constexpr std::int64_t some = 256 << 20;  // bytes: for OpenEXR's blocks in flight, and for what it needs beside them

/// As many threads as have work within that; each keeps two blocks.
int decoding_threads(std::int64_t block_bytes) { return int(std::min<std::int64_t>(Imf::globalThreadCount(), some / (2 * block_bytes))); }

/// What decoding may take: each block, its packed form, and the planes that DWA makes of it, two or three times its size.
std::int64_t decoding_bytes(std::int64_t block_bytes) {
  constexpr std::int64_t copies = 6;
  return some + copies * block_bytes * std::max(1, 2 * decoding_threads(block_bytes));
}

/// Runs library code, watched; what it throws becomes one line that begins with `place`.
template <class Work>
void in_library(const std::string& place, Foreign code, const std::string& file, const Work& work) {
  const InForeignCode watched(code, file);
  try {
    work();
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::memory, place + ": not enough memory to decode it");
  } catch (const std::exception& fault) {
    // Its threads hand on only the text of what they caught.
    const bool memory = std::strstr(fault.what(), "Failed to allocate") || std::strstr(fault.what(), "bad_alloc");
    if (memory) throw Error(ErrorKind::memory, place + ": not enough memory to decode it");
    throw Error(ErrorKind::input, place + ": " + cause(fault.what()));
  }
}

/// Rows that are compressed together: reading whole blocks decodes each of them once.
int block_rows(const Imf::Header& header) {
  if (header.hasTileDescription() && header.hasType() && Imf::isTiled(header.type())) return int(header.tileDescription().ySize);
  switch (header.compression()) {
    case Imf::ZIP_COMPRESSION:
    case Imf::PXR24_COMPRESSION:
      return 16;
    case Imf::PIZ_COMPRESSION:
    case Imf::B44_COMPRESSION:
    case Imf::B44A_COMPRESSION:
    case Imf::DWAA_COMPRESSION:
      return 32;
    case Imf::DWAB_COMPRESSION:
      return 256;
    default:
      return 1;
  }
}

void decode_rows(Imf::InputPart& input, const Window& rows, std::span<const Destination> destinations) {
  Imf::FrameBuffer frame;
  const Imath::V2i origin(rows.min_x, rows.min_y);
  for (const Destination& to : destinations)
    frame.insert(to.channel, Imf::Slice::Make(pixel_type(to.type), to.first, origin, rows.width(), rows.height(), to.x_stride, to.y_stride));
  input.setFrameBuffer(frame);
  input.readPixels(rows.min_y, rows.max_y - 1);
}

void copy_columns(const Destination& from, const Window& decoded, const Destination& to, const Window& asked) {
  const std::size_t bytes = sample_bytes(to.type);
  for (int y = decoded.min_y; y < decoded.max_y; ++y) {
    const char* source = static_cast<const char*>(from.first) + std::size_t(y - decoded.min_y) * from.y_stride +
                         std::size_t(asked.min_x - decoded.min_x) * from.x_stride;
    char* target = static_cast<char*>(to.first) + std::size_t(y - asked.min_y) * to.y_stride;
    for (int x = asked.min_x; x < asked.max_x; ++x, source += from.x_stride, target += to.x_stride) std::memcpy(target, source, bytes);
  }
}

/// OpenEXR decodes whole rows: those of a narrower window go through a block of rows of our own.
void decode_columns(Imf::InputPart& input, const Window& data, const Window& asked, std::span<const Destination> destinations) {
  constexpr std::size_t block_bytes = std::size_t(64) << 20;  // enough rows to keep the decoder's threads busy
  std::size_t row_bytes = 0;
  for (const Destination& to : destinations) row_bytes += std::size_t(data.width()) * sample_bytes(to.type);
  const int block = block_rows(input.header());
  const std::size_t blocks = std::max<std::size_t>(1, block_bytes / (row_bytes * std::size_t(block)));
  const std::int64_t step = std::int64_t(std::min(blocks, std::size_t(data.height() / block + 1))) * block;

  std::vector<char> scratch;
  std::int64_t first = data.min_y + (std::int64_t(asked.min_y) - data.min_y) / step * step;
  for (; first < asked.max_y; first += step) {
    const Window rows{data.min_x, int(std::max<std::int64_t>(first, asked.min_y)), data.max_x,
                      int(std::min<std::int64_t>(first + step, asked.max_y))};
    scratch.resize(row_bytes * std::size_t(rows.height()));
    std::vector<Destination> inner(destinations.begin(), destinations.end());
    char* next = scratch.data();
    for (Destination& to : inner) {
      to.first = next;
      to.x_stride = sample_bytes(to.type);
      to.y_stride = to.x_stride * std::size_t(data.width());
      next += to.y_stride * std::size_t(rows.height());
    }
    decode_rows(input, rows, inner);
    for (std::size_t i = 0; i < inner.size(); ++i) copy_columns(inner[i], rows, destinations[i], asked);
  }
}

const Imf::Attribute* find_attribute(const Imf::Header& header, const std::string& name) {
  if (const auto exact = header.find(name); exact != header.end()) return &exact.attribute();
  for (auto i = header.begin(); i != header.end(); ++i)
    if (strcasecmp(i.name(), name.c_str()) == 0) return &i.attribute();
  return nullptr;
}

template <class Value>
const Value* find_value(const Imf::Header& header, const std::string& name) {
  const auto* const attribute = dynamic_cast<const Imf::TypedAttribute<Value>*>(find_attribute(header, name));
  return attribute ? &attribute->value() : nullptr;
}

template <class Matrix>
std::vector<double> numbers_of(const Matrix& matrix) {
  return {&matrix.x[0][0], &matrix.x[0][0] + 16};
}

}  // namespace

const char* name_of(SampleType type) { return type == SampleType::half_float ? "half" : type == SampleType::float32 ? "float" : "uint"; }

bool Part::has_channel(const std::string& channel) const {
  return std::any_of(channels.begin(), channels.end(), [&](const Channel& c) { return c.name == channel; });
}

struct ExrFile::State {
  explicit State(const std::filesystem::path& file) : path(file), stream(file) {}

  std::string place(int part) const { return stream.name() + ": part " + std::to_string(part); }

  std::filesystem::path path;
  InputStream stream;
  std::unique_ptr<Imf::MultiPartInputFile> file;
  std::vector<Part> parts;
  std::vector<std::string> views;
  std::int64_t block_bytes = 0;  ///< of the largest block of rows or tile
  std::int64_t room = 0;         ///< bytes, for other threads
  std::mutex mutex;              ///< OpenEXR keeps one frame buffer a part: setting it and reading belong together
};

ExrFile::ExrFile(const std::filesystem::path& file, const ReadLimits& limits) : state_(std::make_unique<State>(file)) {
  State& state = *state_;
  static std::once_flag threads;
  std::call_once(threads, [] { Imf::setGlobalThreadCount(int(std::thread::hardware_concurrency())); });  // OpenEXR's own default is none
  state.block_bytes = check_headers(state.stream, limits);
  constexpr std::int64_t header_bytes = 2 * some;  // attributes of 64 MB at most, chunk tables, and our copy of them
  in_library(state.stream.name(), Foreign::header, state.stream.name(), [&] {
    const Allowance allowance(header_bytes);
    // No reconstruction of a missing chunk table: it scans the whole file by lengths that the file claims, and a file without a table
    // was never finished, so its pixels are not to be trusted.
    constexpr bool reconstruct = false;
    state.stream.seekg(0);
    state.file = std::make_unique<Imf::MultiPartInputFile>(state.stream, decoding_threads(state.block_bytes), reconstruct);
    for (int i = 0; i < state.file->parts(); ++i) state.parts.push_back(describe(i, state.file->header(i)));
    if (const auto* const names = find_value<Imf::StringVector>(state.file->header(0), "multiView")) state.views = *names;
  });
}

ExrFile::~ExrFile() = default;
ExrFile::ExrFile(ExrFile&&) noexcept = default;

const std::filesystem::path& ExrFile::path() const { return state_->path; }
const std::vector<Part>& ExrFile::parts() const { return state_->parts; }
const std::vector<std::string>& ExrFile::views() const { return state_->views; }
int ExrFile::rows_in_block(int part) const { return block_rows(state_->parts[std::size_t(part)].header); }
void ExrFile::leave_room(std::int64_t bytes) { state_->room = bytes; }

namespace {

void check_request(const std::string& place, const Part& part, const Window& asked, std::span<const Destination> destinations) {
  const Window& data = part.data_window;
  if (asked.empty() || asked.min_x < data.min_x || asked.min_y < data.min_y || asked.max_x > data.max_x || asked.max_y > data.max_y)
    throw Error(ErrorKind::internal, place + ": window outside the data window");
  for (const Destination& to : destinations) {
    const std::string name = '"' + printable(to.channel) + '"';
    const Imf::Channel* const channel = part.header.channels().findChannel(to.channel);
    if (!channel) throw Error(ErrorKind::input, place + ": no channel " + name);
    if (subsampled(*channel))
      throw Error(ErrorKind::input, place + ": channel " + name + " is stored for every " + std::to_string(channel->xSampling) + "x" +
                                        std::to_string(channel->ySampling) + " pixels (only full resolution is read)");
  }
}

}  // namespace

void ExrFile::read(int index, const Window& window, std::span<const Destination> destinations) const {
  if (index < 0 || index >= int(state_->parts.size()))
    throw Error(ErrorKind::input, state_->place(index) + ": not there (the file has " + std::to_string(state_->parts.size()) + ")");
  const Part& part = state_->parts[std::size_t(index)];
  check_request(state_->place(index), part, window, destinations);

  // A frame buffer holds a channel once; a channel wanted in two places is copied, or, as another type, decoded again.
  std::vector<Destination> once, again;
  std::set<std::string> seen;
  for (const Destination& to : destinations) (seen.insert(to.channel).second ? once : again).push_back(to);
  if (once.empty()) return;

  const bool whole_rows = window.min_x == part.data_window.min_x && window.max_x == part.data_window.max_x;
  const char* const what = state_->file->partComplete(index) ? ": damaged pixel data" : ": incomplete pixel data (writing it was never finished)";
  in_library(state_->place(index) + what, Foreign::pixels, state_->place(index), [&] {
    Imf::InputPart input(*state_->file, index);
    if (reads_zip_rows(part, once)) return read_zip_rows(input, part, window, once, rows_in_block(index), decoding_threads(state_->block_bytes));
    const std::lock_guard lock(state_->mutex);
    const Allowance allowance(decoding_bytes(state_->block_bytes) + state_->room);
    whole_rows ? decode_rows(input, window, once) : decode_columns(input, part.data_window, window, once);
  });
  std::vector<Destination> of_other_types;
  for (const Destination& to : again) {
    const auto first = std::find_if(once.begin(), once.end(), [&](const Destination& d) { return d.channel == to.channel; });
    if (first->type == to.type)
      copy_columns(*first, window, to, window);
    else
      of_other_types.push_back(to);
  }
  read(index, window, of_other_types);
}

std::optional<std::string> text_attribute(const Imf::Header& header, const std::string& name) {
  const auto* const text = find_value<std::string>(header, name);
  return text ? std::optional(*text) : std::nullopt;
}

std::optional<std::vector<double>> matrix_attribute(const Imf::Header& header, const std::string& name) {
  if (const auto* const matrix = find_value<Imath::M44f>(header, name)) return numbers_of(*matrix);
  if (const auto* const matrix = find_value<Imath::M44d>(header, name)) return numbers_of(*matrix);
  return std::nullopt;
}

std::vector<std::string> attribute_names(const Imf::Header& header) {
  std::vector<std::string> names;
  for (auto i = header.begin(); i != header.end(); ++i) names.emplace_back(i.name());
  return names;
}

}  // namespace relume
