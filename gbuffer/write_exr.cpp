// Writes scan lines through OpenEXR onto a WholeFile, so that every byte is checked and the name appears last.
#include "gbuffer/write_exr.h"

#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfThreading.h>
#include <strings.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <mutex>
#include <thread>

#include "gbuffer/encoding.h"
#include "gbuffer/error.h"
#include "gbuffer/half_floats.h"
#include "gbuffer/output_stream.h"
#include "gbuffer/printable.h"
#include "gbuffer/whole_file.h"
#include "gbuffer/zip_output.h"

namespace relume {
namespace {

constexpr std::array<Imf::Compression, 10> compressions = {
    Imf::NO_COMPRESSION,    Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION, Imf::ZIP_COMPRESSION,  Imf::PIZ_COMPRESSION,
    Imf::PXR24_COMPRESSION, Imf::B44_COMPRESSION, Imf::B44A_COMPRESSION, Imf::DWAA_COMPRESSION, Imf::DWAB_COMPRESSION};

bool begins_with(const std::string& text, const char* beginning) { return strncasecmp(text.c_str(), beginning, std::strlen(beginning)) == 0; }

/// Attributes that say how the input was stored, or speak of channels and pixels that are not in the output.
bool is_about_the_input(const std::string& name) {
  static const std::vector<std::string> own = {"channels",
                                               "compression",
                                               "dataWindow",
                                               "displayWindow",
                                               "lineOrder",
                                               "tiles",
                                               "type",
                                               "name",
                                               "view",
                                               "multiView",
                                               "chunkCount",
                                               "version",
                                               "preview",
                                               "dwaCompressionLevel",
                                               "maxSamplesPerPixel",
                                               "deepImageState",
                                               "BlenderMultiChannel"};  // "the channels are named as Blender names them": ours are not
  if (std::any_of(own.begin(), own.end(), [&](const std::string& each) { return strcasecmp(name.c_str(), each.c_str()) == 0; })) return true;
  if (begins_with(name, "cryptomatte/")) return true;  // tells the names of ids whose channels are not written
  return begins_with(name, "tiff:");                   // storage too, and a RowsPerStrip of 0 ends OpenImageIO by SIGFPE (reliability, finding 3)
}

Imf::Header kept_attributes(const Imf::Header& like, const std::vector<std::pair<std::string, std::string>>& metadata) {
  Imf::Header header;
  // Ours win over the input's of the same name, which may be of another type.
  const auto is_ours = [&](const std::string& name) {
    return std::any_of(metadata.begin(), metadata.end(), [&](const auto& entry) { return entry.first == name; });
  };
  for (auto i = like.begin(); i != like.end(); ++i)
    if (!is_about_the_input(i.name()) && !is_ours(i.name())) header.insert(i.name(), i.attribute());
  for (const auto& [key, text] : metadata) header.insert(key, Imf::StringAttribute(text));
  return header;
}

Imath::Box2i box_of(const Window& window) { return {{window.min_x, window.min_y}, {window.max_x - 1, window.max_y - 1}}; }

}  // namespace

const float* Source::row(int y, int width, std::vector<float>& gathered) const {
  const char* const from = reinterpret_cast<const char*>(first) + std::size_t(y) * y_stride;
  if (x_stride == sizeof(float)) return reinterpret_cast<const float*>(from);
  gathered.resize(std::size_t(width));
  for (std::size_t x = 0; x < gathered.size(); ++x) std::memcpy(&gathered[x], from + x * x_stride, sizeof(float));
  return gathered.data();
}

const std::vector<std::string>& compression_names() {
  static const std::vector<std::string> names = {"none", "rle", "zips", "zip", "piz", "pxr24", "b44", "b44a", "dwaa", "dwab"};
  return names;
}

Imf::Compression compression_named(const std::string& name) {
  const std::vector<std::string>& names = compression_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return compressions[std::size_t(found - names.begin())];
  std::string all;
  for (const std::string& each : names) all += (all.empty() ? "" : ", ") + each;
  throw Error(ErrorKind::input, "no compression \"" + printable(name) + "\" (" + all + ")");
}

struct ExrWriter::State {
  State(const std::filesystem::path& path, const OutputFormat& format)
      : name(printable(path.native())), type(format.type), file(path, format.overwrite) {}

  void verify(const std::filesystem::path& written) const;
  void encode(int rows, std::span<const Source> sources);
  Imf::Slice half_slice(const Source& source, int rows, std::vector<half>& samples) const;

  std::string name;  ///< printable
  SampleType type;
  Window window;
  std::vector<std::string> channels;
  int next_row = 0;
  WholeFile file;
  OutputStream stream{file};
  std::unique_ptr<Imf::OutputFile> output;  ///< of the codecs that OpenEXR encodes
  std::unique_ptr<ZipOutput> zip;           ///< of the others
};

ExrWriter::ExrWriter(const std::filesystem::path& file, const OutputFormat& format, const Imf::Header& like, const Window& data_window,
                     const Window& display_window, const std::vector<std::string>& channels,
                     const std::vector<std::pair<std::string, std::string>>& metadata) {
  const Imf::Compression compression = compression_named(format.compression);
  if (format.type == SampleType::uint32 || data_window.empty() || display_window.empty() || channels.empty())
    throw Error(ErrorKind::internal, printable(file.native()) + ": an output needs pixels, channels and a type of float or half");
  static std::once_flag threads;
  std::call_once(threads, [] { Imf::setGlobalThreadCount(int(std::thread::hardware_concurrency())); });  // OpenEXR's own default is none
  state_ = std::make_unique<State>(file, format);
  State& state = *state_;
  state.window = data_window;
  state.channels = channels;
  state.next_row = data_window.min_y;
  while_encoding(state.name, [&] {
    Imf::Header header = kept_attributes(like, metadata);
    header.dataWindow() = box_of(data_window);
    header.displayWindow() = box_of(display_window);
    header.compression() = compression;
    const Imf::Channel stored(format.type == SampleType::float32 ? Imf::FLOAT : Imf::HALF);
    for (const std::string& channel : channels) header.channels().insert(channel, stored);
    if (compression == Imf::ZIP_COMPRESSION || compression == Imf::ZIPS_COMPRESSION)
      state.zip = std::make_unique<ZipOutput>(state.stream, header);
    else
      state.output = std::make_unique<Imf::OutputFile>(state.stream, header, Imf::globalThreadCount());
  });
}

ExrWriter::~ExrWriter() = default;

Imf::Slice ExrWriter::State::half_slice(const Source& source, int rows, std::vector<half>& samples) const {
  samples.resize(std::size_t(window.width()) * std::size_t(rows));
  std::vector<float> gathered;
  for (int y = 0; y < rows; ++y)
    halves_of(source.row(y, window.width(), gathered), samples.data() + std::size_t(y) * std::size_t(window.width()), std::size_t(window.width()));
  return Imf::Slice::Make(Imf::HALF, samples.data(), Imath::V2i(window.min_x, next_row), window.width(), rows);
}

void ExrWriter::State::encode(int rows, std::span<const Source> sources) {
  std::vector<std::vector<half>> halves(sources.size());
  Imf::FrameBuffer frame;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const Source& from = sources[i];
    if (type == SampleType::half_float)
      frame.insert(from.channel, half_slice(from, rows, halves[i]));
    else
      frame.insert(from.channel,
                   Imf::Slice::Make(Imf::FLOAT, from.first, Imath::V2i(window.min_x, next_row), window.width(), rows, from.x_stride, from.y_stride));
  }
  output->setFrameBuffer(frame);
  output->writePixels(rows);
}

void ExrWriter::write_rows(int rows, std::span<const Source> sources) {
  State& state = *state_;
  if (rows < 1 || rows > state.window.max_y - state.next_row) throw Error(ErrorKind::internal, state.name + ": more rows than the window has");
  for (const std::string& channel : state.channels)
    if (std::none_of(sources.begin(), sources.end(), [&](const Source& source) { return source.channel == channel; }))
      throw Error(ErrorKind::internal, state.name + ": no rows given for channel \"" + printable(channel) + '"');
  while_encoding(state.name, [&] { state.zip ? state.zip->write_rows(rows, sources) : state.encode(rows, sources); });
  state.next_row += rows;
}

/// The file reads back: our own scan accepts the header, the chunk table is complete, and the last row decodes.
void ExrWriter::State::verify(const std::filesystem::path& written) const {
  try {
    ReadLimits limits;
    limits.max_channels = int(channels.size());
    const ExrFile back(written, limits);
    const Part& part = back.parts().at(0);
    std::vector<float> row(std::size_t(window.width()));
    std::vector<Destination> all;
    for (const std::string& channel : channels) all.push_back({channel, SampleType::float32, row.data(), sizeof(float), row.size() * sizeof(float)});
    if (part.data_window != window || part.channels.size() != channels.size()) throw Error(ErrorKind::output, "another window or other channels");
    back.read(0, {window.min_x, window.max_y - 1, window.max_x, window.max_y}, all);
  } catch (const Error& fault) {
    throw Error(ErrorKind::output, name + ": what was written does not read back: " + fault.what());
  }
}

void ExrWriter::commit() {
  State& state = *state_;
  if (state.next_row != state.window.max_y)
    throw Error(ErrorKind::internal, state.name + ": " + std::to_string(state.window.max_y - state.next_row) + " rows were not written");
  while_encoding(state.name, [&] {
    state.output.reset();  // writes the chunk table
    if (state.zip) state.zip->finish();
    state.stream.rethrow();
    state.file.commit([&](const std::filesystem::path& written) { state.verify(written); });
  });
}

}  // namespace relume
