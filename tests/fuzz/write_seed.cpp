// Seeds written: the made-up scene, or what no renderer should write, by channel.
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfTiledOutputPart.h>

#include <limits>

#include "tests/fuzz/seed.h"
#include "tests/make_gbuffer.h"

namespace relume {
namespace {

std::string name_of(const std::string& channel) { return channel.substr(0, channel.find('=')); }
std::string source_of(const std::string& channel) { return channel.substr(channel.find('=') + 1); }

/// Samples of one part, kept alive with the frame buffer that points to them.
struct Samples {
  std::vector<std::vector<float>> floats;
  std::vector<std::vector<half>> halves;
  std::vector<std::vector<unsigned>> numbers;
  Imf::FrameBuffer frame;
};

Imf::PixelType type_of(const Seed& seed, const std::string& channel) {
  return source_of(channel) == "id" && seed.type == Imf::UINT ? Imf::UINT : seed.type;
}

/// The mean over the pixel's samples, or what no renderer should write.
float value_of(const Seed& seed, const std::string& source, int i) {
  const scene::Reader reader = scene::reader_of(source);
  const int fine = seed.side * seed.samples, x = i % seed.side * seed.samples, y = i / seed.side * seed.samples;
  const MadeUpGBuffer made = MadeUpGBuffer::of_size(fine, fine);
  float sum = 0;
  for (int s = 0; s < seed.samples * seed.samples; ++s) {
    const ScenePixel pixel = scene_at(made, x + s % seed.samples, y + s / seed.samples);
    sum += source == "id" ? float(pixel.id) : source == "depth" ? float(scene_eye_z - pixel.position.z) : reader(pixel);
  }
  const float strange[] = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 0, -1e30f, 7e8f};
  return seed.ailing && i % 9 < 5 && i > 2 * seed.side ? strange[i % 9] : sum / float(seed.samples * seed.samples);
}

void fill(Samples& s, const Seed& seed, const SeedPart& part) {
  for (const std::string& channel : part.channels) {
    s.floats.emplace_back();
    for (int i = 0; i < seed.side * seed.side; ++i) s.floats.back().push_back(value_of(seed, source_of(channel), i));
    s.halves.emplace_back(s.floats.back().begin(), s.floats.back().end());
    s.numbers.emplace_back();
    for (const float value : s.floats.back()) s.numbers.back().push_back(value > 0 && value < 1e9f ? unsigned(value) : 0);
    const Imf::PixelType type = type_of(seed, channel);
    void* const first = type == Imf::FLOAT  ? static_cast<void*>(s.floats.back().data())
                        : type == Imf::HALF ? static_cast<void*>(s.halves.back().data())
                                            : static_cast<void*>(s.numbers.back().data());
    s.frame.insert(name_of(channel), Imf::Slice::Make(type, first, {0, 0}, seed.side, seed.side));
  }
}

Imf::Header header_of(const Seed& seed, const SeedPart& part) {
  Imf::Header header(seed.side, seed.side);
  header.compression() = seed.compression;
  header.setType(seed.tile ? Imf::TILEDIMAGE : Imf::SCANLINEIMAGE);
  if (seed.parts.size() > 1) header.setName(part.name);
  if (!part.view.empty()) header.setView(part.view);
  if (seed.tile) header.setTileDescription({unsigned(seed.tile), unsigned(seed.tile), seed.levels, Imf::ROUND_DOWN});
  for (const std::string& channel : part.channels) header.channels().insert(name_of(channel), Imf::Channel(type_of(seed, channel)));
  return header;
}

void write_tiles(Imf::MultiPartOutputFile& file, const Samples& samples) {
  Imf::TiledOutputPart out(file, 0);
  out.setFrameBuffer(samples.frame);
  for (int y = 0; y < out.numYLevels(); ++y)
    for (int x = 0; x < out.numXLevels(); ++x)
      if (out.isValidLevel(x, y)) out.writeTiles(0, out.numXTiles(x) - 1, 0, out.numYTiles(y) - 1, x, y);
}

}  // namespace

void write(const Seed& seed, const std::filesystem::path& folder) {
  std::vector<Imf::Header> headers;
  for (const SeedPart& part : seed.parts) headers.push_back(header_of(seed, part));
  seed.edit(headers.front());
  Imf::MultiPartOutputFile file((folder / (seed.name + ".exr")).c_str(), headers.data(), int(headers.size()));
  for (std::size_t p = 0; p < seed.parts.size(); ++p) {
    Samples samples;
    fill(samples, seed, seed.parts[p]);
    if (seed.tile) {
      write_tiles(file, samples);
      continue;
    }
    Imf::OutputPart out(file, int(p));
    out.setFrameBuffer(samples.frame);
    out.writePixels(seed.side);
  }
}

}  // namespace relume
