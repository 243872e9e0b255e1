// The yardstick of `relume shade`: reads every channel of an EXR and writes them again with OpenEXR alone, on all cores.
//
//   exr_copy IN.exr OUT.exr
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfThreading.h>

#include <cstdio>
#include <thread>
#include <vector>

int main(int argc, char** argv) {
  if (argc != 3) return std::fprintf(stderr, "usage: exr_copy IN.exr OUT.exr\n"), 2;
  Imf::setGlobalThreadCount(int(std::thread::hardware_concurrency()));
  Imf::InputFile in(argv[1]);
  const Imath::Box2i window = in.header().dataWindow();
  const std::size_t width = std::size_t(window.max.x - window.min.x + 1), height = std::size_t(window.max.y - window.min.y + 1);
  std::vector<std::vector<char>> planes;
  Imf::FrameBuffer frame;
  for (auto channel = in.header().channels().begin(); channel != in.header().channels().end(); ++channel) {
    const std::size_t size = channel.channel().type == Imf::HALF ? 2 : 4;
    planes.emplace_back(width * height * size);
    frame.insert(channel.name(), Imf::Slice::Make(channel.channel().type, planes.back().data(), window, size, size * width));
  }
  in.setFrameBuffer(frame);
  in.readPixels(window.min.y, window.max.y);
  Imf::OutputFile out(argv[2], in.header());
  out.setFrameBuffer(frame);
  out.writePixels(int(height));
}
