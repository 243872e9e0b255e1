// Makes EXR files of every storage, sample type and codec with OpenEXR itself, filled with values that a test can compute again.
#pragma once

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfTiledOutputPart.h>
#include <half.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "gbuffer/window.h"

/// Small whole numbers: exact in every sample type, and smooth enough for the lossy codecs to keep within their promise.
inline float value_at(int x, int y, int channel) { return float((x + 100) + 2 * (y + 100) + 50 * channel); }

struct PartSpec {
  std::string name, view;
  relume::Window data, display;
  Imf::Compression compression = Imf::ZIP_COMPRESSION;
  bool tiled = false;
  Imf::LineOrder order = Imf::INCREASING_Y;
  std::vector<std::pair<std::string, Imf::PixelType>> channels;
};

inline Imf::Header header_of(const PartSpec& part) {
  Imf::Header header({{part.display.min_x, part.display.min_y}, {part.display.max_x - 1, part.display.max_y - 1}},
                     {{part.data.min_x, part.data.min_y}, {part.data.max_x - 1, part.data.max_y - 1}}, 1, {0, 0}, 1, part.order, part.compression);
  header.setName(part.name);
  header.setType(part.tiled ? Imf::TILEDIMAGE : Imf::SCANLINEIMAGE);
  if (!part.view.empty()) header.setView(part.view);
  if (part.tiled) header.setTileDescription({24, 16, Imf::MIPMAP_LEVELS});
  for (const auto& [name, type] : part.channels) header.channels().insert(name, Imf::Channel(type));
  return header;
}

inline void write_part(Imf::MultiPartOutputFile& file, int index, const PartSpec& part) {
  Imf::FrameBuffer frame;
  const std::size_t pixels = std::size_t(part.data.pixels());
  std::vector<std::vector<char>> planes;
  for (std::size_t c = 0; c < part.channels.size(); ++c) {
    const Imf::PixelType type = part.channels[c].second;
    const std::size_t bytes = type == Imf::HALF ? 2 : 4;
    planes.emplace_back(pixels * bytes);
    for (std::size_t i = 0; i < pixels; ++i) {
      const int x = part.data.min_x + int(i) % part.data.width(), y = part.data.min_y + int(i) / part.data.width();
      const float value = value_at(x, y, int(c));
      char* const to = planes.back().data() + i * bytes;
      if (type == Imf::HALF) *reinterpret_cast<half*>(to) = half(value);
      if (type == Imf::FLOAT) *reinterpret_cast<float*>(to) = value;
      if (type == Imf::UINT) *reinterpret_cast<unsigned*>(to) = unsigned(value);
    }
    frame.insert(part.channels[c].first,
                 Imf::Slice::Make(type, planes.back().data(), {part.data.min_x, part.data.min_y}, part.data.width(), part.data.height()));
  }
  if (!part.tiled) {
    Imf::OutputPart out(file, index);
    out.setFrameBuffer(frame);
    out.writePixels(part.data.height());
    return;
  }
  Imf::TiledOutputPart out(file, index);
  out.setFrameBuffer(frame);
  // Coarser levels hold the corner of the finest: a reader that took one of them would be seen.
  for (int level = 0; level < out.numLevels(); ++level) out.writeTiles(0, out.numXTiles(level) - 1, 0, out.numYTiles(level) - 1, level);
}

inline void write_file(const std::filesystem::path& path, const std::vector<PartSpec>& parts) {
  std::vector<Imf::Header> headers;
  for (const PartSpec& part : parts) headers.push_back(header_of(part));
  Imf::MultiPartOutputFile file(path.c_str(), headers.data(), int(headers.size()));
  for (std::size_t i = 0; i < parts.size(); ++i) write_part(file, int(i), parts[i]);
}
