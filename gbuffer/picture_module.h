// What the module relume_picture.so offers: plain C functions, since the program looks them up by name when a picture is first asked for.
#pragma once

#include <cstddef>

namespace relume {

struct PictureShape {
  int width, height, channels;
  int alpha_channel;  ///< -1: none
  bool srgb;          ///< the stored values follow the sRGB curve
};

struct SheetTile {
  const char* label;
  const unsigned char* pixels;  ///< 3 channels
  int width, height;
};

/// Pixels. A tile stands `gap` from its neighbours and from the border, its label in the `label_height` below it.
struct SheetShape {
  int columns, tile_width, tile_height, label_height, gap;
};

using PictureBytes = void(void* context, const void* data, std::size_t bytes);  ///< takes the encoded file
using PictureMemory = float*(void* context, const PictureShape& shape);         ///< gives room for all values
using EncodePng = const char*(const unsigned char* pixels, int width, int height, int channels, PictureBytes* take, void* context);
using ComposeSheet = const char*(const SheetTile* tiles, int count, const SheetShape& shape, unsigned char* sheet, int width, int height);
using DecodePicture = const char*(const char* file, const char* reader, PictureMemory* room, void* context);

}  // namespace relume

/// Each returns null, or what is wrong; the text lives until the thread's next call.
extern "C" relume::EncodePng relume_encode_png;
extern "C" relume::ComposeSheet relume_compose_sheet;
extern "C" relume::DecodePicture relume_decode_picture;
