// Pictures other than EXR, read and written by OpenImageIO, which is loaded only when one is asked for: linking it costs
// every start of the program 0.2 s and 130 MB (research: reliability, finding 4).
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "gbuffer/picture_module.h"

namespace relume {

struct Picture {
  int width = 0, height = 0, channels = 0;
  std::vector<float> values;  ///< row by row from the top, interleaved, scene-linear
};

/// Writes 8-bit sRGB (IEC 61966-2-1 transfer curve) of 1, 3 or 4 channels, the fourth alpha (colours multiplied by it, as in EXR; PNG stores
/// them divided); beyond 0..1 is clipped, NaN is black. Whole or not at all. Error{output}.
void write_png(const std::filesystem::path& file, const Picture& picture, double exposure_stops, bool overwrite);

/// 8-bit codes as a PNG holds them, row by row from the top, interleaved.
struct CodedPicture {
  int width = 0, height = 0, channels = 0;
  std::vector<unsigned char> codes;
};

/// The nearest 8-bit code of IEC 61966-2-1.
std::uint8_t srgb_code(float linear);

/// Writes the codes as they are. Whole or not at all. Error{output}.
void write_png(const std::filesystem::path& file, const CodedPicture& picture, bool overwrite);

/// Scales the tiles (3 channels each) and lays them out in rows on the sheet, whose size fits, each above its label. Error{output}.
void compose_sheet(std::span<const SheetTile> tiles, const SheetShape& shape, CodedPicture& sheet);

/// Reads PNG, JPEG, TIFF, HDR, TGA, PFM by an explicit reader chosen from the extension (never by guessing). 8-bit values, and PNG's 16-bit
/// ones, are taken as sRGB and linearised; alpha is kept apart from colour, as stored. Error{input}.
Picture read_picture(const std::filesystem::path& file);

}  // namespace relume
