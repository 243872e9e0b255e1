// PartsWriter: OpenEXR's MultiPartOutputFile onto a WholeFile.
#include "gbuffer/write_parts.h"

#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfThreading.h>

#include <new>
#include <thread>

#include "gbuffer/encoding.h"
#include "gbuffer/error.h"
#include "gbuffer/half_floats.h"
#include "gbuffer/output_stream.h"
#include "gbuffer/printable.h"
#include "gbuffer/watched.h"
#include "gbuffer/whole_file.h"
#include "gbuffer/write_exr.h"

namespace relume {
namespace {

Imath::Box2i box_of(const Window& window) { return {{window.min_x, window.min_y}, {window.max_x - 1, window.max_y - 1}}; }

Imf::PixelType stored(SampleType type) { return type == SampleType::uint32 ? Imf::UINT : type == SampleType::half_float ? Imf::HALF : Imf::FLOAT; }

Imf::Header header_of(const OutputPart& part, const Window& display, Imf::Compression compression) {
  Imf::Header header = part.attributes;
  header.dataWindow() = box_of(part.window);
  header.displayWindow() = box_of(display);
  header.compression() = compression;
  header.setName(part.name);
  header.setType(Imf::SCANLINEIMAGE);
  for (const Channel& channel : part.channels) header.channels().insert(channel.name, Imf::Channel(stored(channel.type)));
  return header;
}

}  // namespace

struct PartsWriter::State {
  State(const std::filesystem::path& path, bool overwrite, const std::vector<OutputPart>& all)
      : name(printable(path.native())), parts(all), file(path, overwrite) {
    for (const OutputPart& part : all) next_rows.push_back(part.window.min_y);
  }

  /// The last row of each part decodes.
  void verify(const std::filesystem::path& written) const {
    try {
      const ExrFile back(written);
      for (std::size_t p = 0; p < parts.size(); ++p) {
        const Window& w = parts[p].window;
        std::vector<float> row(std::size_t(w.width()));
        const Destination first{parts[p].channels.front().name, SampleType::float32, row.data(), sizeof(float), row.size() * sizeof(float)};
        back.read(int(p), {w.min_x, w.max_y - 1, w.max_x, w.max_y}, {&first, 1});
      }
    } catch (const Error& fault) {
      throw Error(ErrorKind::output, name + ": what was written does not read back: " + fault.what());
    }
  }

  std::string name;  ///< printable
  std::vector<OutputPart> parts;
  std::vector<int> next_rows;
  WholeFile file;
  OutputStream stream{file};
  std::unique_ptr<Imf::MultiPartOutputFile> output;
};

PartsWriter::PartsWriter(const std::filesystem::path& file, const std::string& compression, bool overwrite, const Window& display,
                         const std::vector<OutputPart>& parts)
    : state_(std::make_unique<State>(file, overwrite, parts)) {
  const Imf::Compression codec = compression_named(compression);
  Imf::setGlobalThreadCount(int(std::thread::hardware_concurrency()));  // OpenEXR's own default is none
  std::vector<Imf::Header> headers;
  for (const OutputPart& part : parts) headers.push_back(header_of(part, display, codec));
  while_encoding(state_->name,
                 [&] { state_->output = std::make_unique<Imf::MultiPartOutputFile>(state_->stream, headers.data(), int(headers.size())); });
}

PartsWriter::~PartsWriter() = default;

void PartsWriter::write_rows(std::size_t index, int rows, std::span<const void* const> samples) {
  State& s = *state_;
  const OutputPart& part = s.parts[index];
  const std::size_t width = std::size_t(part.window.width()), count = width * std::size_t(rows);
  std::vector<std::vector<half>> halves;
  Imf::FrameBuffer frame;
  for (std::size_t c = 0; c < part.channels.size(); ++c) {
    const Channel& channel = part.channels[c];
    const void* from = samples[c];
    if (channel.type == SampleType::half_float) {
      halves.emplace_back(count);
      halves_of(static_cast<const float*>(from), halves.back().data(), count);
      from = halves.back().data();
    }
    frame.insert(channel.name,
                 Imf::Slice::Make(stored(channel.type), from, Imath::V2i(part.window.min_x, s.next_rows[index]), part.window.width(), rows));
  }
  while_encoding(s.name, [&] {
    Imf::OutputPart out(*s.output, int(index));
    out.setFrameBuffer(frame);
    out.writePixels(rows);
  });
  s.next_rows[index] += rows;
  beat();
}

void PartsWriter::commit() {
  State& s = *state_;
  for (std::size_t p = 0; p < s.parts.size(); ++p)
    if (s.next_rows[p] != s.parts[p].window.max_y)
      throw Error(ErrorKind::internal, s.name + ": rows of part " + s.parts[p].name + " were not written");
  while_encoding(s.name, [&] {
    s.output.reset();  // writes the chunk tables
    s.stream.rethrow();
    s.file.commit([&](const std::filesystem::path& written) { s.verify(written); });
  });
}

}  // namespace relume
