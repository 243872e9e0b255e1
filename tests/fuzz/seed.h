// A seed of the fuzzer: a small file's parts, names, attributes and layout, and what of the made-up scene its channels hold.
#pragma once

#include <ImfCompression.h>
#include <ImfHeader.h>
#include <ImfPixelType.h>
#include <ImfTileDescription.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace relume {

inline constexpr int large = 12;  // pixels: some that are clear of edges, for the camera, and files of a few kilobytes
inline constexpr int small = 3;   // too few to recover a camera from, which takes longer than all else

struct SeedPart {
  std::string name, view;
  std::vector<std::string> channels;  ///< "ViewLayer.Normal.X=N.X": the name, and what of the scene it holds
};

struct Seed {
  std::string name;
  std::vector<SeedPart> parts;
  std::function<void(Imf::Header&)> edit = [](Imf::Header&) {};  ///< of the first part
  Imf::Compression compression = Imf::ZIP_COMPRESSION;
  Imf::PixelType type = Imf::FLOAT;
  int tile = 0;  ///< 0: scan lines
  Imf::LevelMode levels = Imf::ONE_LEVEL;
  int side = small;
  int samples = 1;  ///< of a pixel, across and down: it holds their mean
  bool ailing = false;
};

using Channels = std::vector<std::string>;

/// Writes FOLDER/NAME.exr.
void write(const Seed& seed, const std::filesystem::path& folder);

}  // namespace relume
