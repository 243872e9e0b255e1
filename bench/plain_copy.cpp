// copy_exr, as OpenEXR's documentation has it.
#include "bench/plain_copy.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfThreading.h>

#include <thread>
#include <vector>

namespace relume::bench {

void copy_exr(const std::filesystem::path& in, const std::filesystem::path& out) {
  Imf::setGlobalThreadCount(int(std::thread::hardware_concurrency()));
  Imf::InputFile input(in.c_str());
  const Imath::Box2i window = input.header().dataWindow();
  const std::size_t width = std::size_t(window.max.x - window.min.x + 1), height = std::size_t(window.max.y - window.min.y + 1);
  std::vector<std::vector<char>> planes;
  Imf::FrameBuffer frame;
  for (auto channel = input.header().channels().begin(); channel != input.header().channels().end(); ++channel) {
    const std::size_t size = channel.channel().type == Imf::HALF ? 2 : 4;
    planes.emplace_back(width * height * size);
    frame.insert(channel.name(), Imf::Slice::Make(channel.channel().type, planes.back().data(), window, size, size * width));
  }
  input.setFrameBuffer(frame);
  input.readPixels(window.min.y, window.max.y);
  Imf::OutputFile output(out.c_str(), input.header());
  output.setFrameBuffer(frame);
  output.writePixels(int(height));
}

}  // namespace relume::bench
