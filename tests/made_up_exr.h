// Small EXR files for tests, removed when they go out of scope.
#pragma once

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfStringVectorAttribute.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace relume {

struct MadeUpPart {
  std::string name, view;
  std::vector<std::string> channels;  ///< "ids:uint" is a whole-number channel "ids"
};

class MadeUpExr {
 public:
  using Value = std::function<double(const std::string& channel, int x, int y)>;
  using Edit = std::function<void(Imf::Header&)>;

  /// `edit` adds attributes to the first part's header.
  MadeUpExr(const std::vector<MadeUpPart>& parts, int width, int height, const Value& value, const Edit& edit = {}) {
    static int count = 0;
    file = std::filesystem::temp_directory_path() / ("relume-test-" + std::to_string(getpid()) + "-" + std::to_string(count++) + ".exr");
    std::vector<Imf::Header> headers;
    for (const MadeUpPart& part : parts) {
      Imf::Header header(width, height);
      if (!part.name.empty() || parts.size() > 1) header.setName(part.name);
      if (!part.view.empty()) header.setView(part.view);
      header.setType(Imf::SCANLINEIMAGE);
      for (const std::string& channel : part.channels)
        header.channels().insert(plain(channel), Imf::Channel(whole(channel) ? Imf::UINT : Imf::FLOAT));
      if (headers.empty() && edit) edit(header);
      headers.push_back(header);
    }
    Imf::MultiPartOutputFile out(file.c_str(), headers.data(), int(headers.size()));
    for (std::size_t p = 0; p < parts.size(); ++p) write(out, int(p), parts[p], width, height, value);
  }
  ~MadeUpExr() { std::filesystem::remove(file); }
  MadeUpExr(const MadeUpExr&) = delete;
  MadeUpExr& operator=(const MadeUpExr&) = delete;

  std::filesystem::path file;

 private:
  static bool whole(const std::string& channel) { return channel.ends_with(":uint"); }
  static std::string plain(const std::string& channel) { return whole(channel) ? channel.substr(0, channel.size() - 5) : channel; }

  static void write(Imf::MultiPartOutputFile& out, int index, const MadeUpPart& part, int width, int height, const Value& value) {
    const std::size_t pixels = std::size_t(width) * std::size_t(height), stride = 4 * std::size_t(width);
    std::vector<std::vector<float>> floats;
    std::vector<std::vector<std::uint32_t>> numbers;
    Imf::FrameBuffer buffer;
    for (const std::string& channel : part.channels) {
      floats.emplace_back(pixels);
      numbers.emplace_back(pixels);
      for (std::size_t i = 0; i < pixels; ++i) {
        const double v = value(plain(channel), int(i) % width, int(i) / width);
        floats.back()[i] = float(v);
        if (whole(channel)) numbers.back()[i] = v > 0 ? std::uint32_t(std::min(v, 4294967295.0)) : 0;
      }
      char* const base = whole(channel) ? reinterpret_cast<char*>(numbers.back().data()) : reinterpret_cast<char*>(floats.back().data());
      buffer.insert(plain(channel), Imf::Slice(whole(channel) ? Imf::UINT : Imf::FLOAT, base, 4, stride));
    }
    Imf::OutputPart to(out, index);
    to.setFrameBuffer(buffer);
    to.writePixels(height);
  }
};

}  // namespace relume
