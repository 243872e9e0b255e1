// The module around OpenImageIO. A reader is created by its name: opened by file name, OpenImageIO 2.4 tries every reader it has, fetches
// URLs, and crashes on many files that are not what they say (research: reliability, findings 1 and 2).
#include "gbuffer/picture_module.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <cstdint>
#include <exception>
#include <string>
#include <vector>

namespace {

thread_local std::string fault;

const char* say(const std::string& text) {
  fault = text.empty() ? "OpenImageIO gives no reason" : text.substr(0, text.find('\n'));
  return fault.c_str();
}

/// Runs what may throw: nothing crosses the C boundary but a message.
template <class Work>
const char* reported(const Work& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return say("not enough memory");
  } catch (const std::exception& thrown) {
    return say(thrown.what());
  }
}

/// What is refused before a pixel is read, or null.
const char* objection(const OIIO::ImageSpec& spec) {
  constexpr std::int64_t most_values = std::int64_t(1) << 30;  // 4 GiB of floats: a 16k environment fits
  if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1 || spec.depth > 1) return say("holds no flat picture");
  if (spec.nchannels > 64 || std::int64_t(spec.width) * spec.height > most_values / spec.nchannels) return say("is larger than 1073741824 values");
  // OpenImageIO 2.4 divides by it (reliability, finding 3).
  if (spec.get_int_attribute("tiff:RowsPerStrip", 1) < 1) return say("has strips of no rows");
  return nullptr;
}

bool is_srgb(const OIIO::ImageSpec& spec, const std::string& reader) {
  if (OIIO::Strutil::iequals(spec.get_string_attribute("oiio:ColorSpace"), "linear")) return false;
  // A PNG is sRGB whatever its depth (its specification, section 12.3); 16-bit TIFF is used for linear data.
  return spec.format == OIIO::TypeUInt8 || (spec.format == OIIO::TypeUInt16 && reader == "png");
}

OIIO::ImageBuf wrapped(const void* pixels, int width, int height) {
  return {OIIO::ImageSpec(width, height, 3, OIIO::TypeUInt8), const_cast<void*>(pixels)};
}

/// The first font that there is: OpenImageIO brings none. Without one the text is left out.
void write_text(OIIO::ImageBuf& sheet, int x, int y, const std::string& text, int size) {
  static const float light[] = {0.85f, 0.85f, 0.85f};
  for (const char* const font : {"DejaVuSans", "LiberationSans-Regular", "NotoSans-Regular", "FreeSans", "DroidSans"})
    if (OIIO::ImageBufAlgo::render_text(sheet, x, y, text, size, font, light)) return;
  (void)sheet.geterror();  // asked for, it is forgotten
}

/// Whatever is longer than its tile is cut, so that labels do not run into each other.
std::string fitting(const std::string& label, int width, int size) {
  const std::size_t most = std::size_t(width) * 100 / std::size_t(size * 52);  // letters are about half their size wide
  return label.size() <= most ? label : label.substr(0, most > 3 ? most - 3 : 0) + "...";
}

}  // namespace

const char* relume_compose_sheet(const relume::SheetTile* tiles, int count, const relume::SheetShape& shape, unsigned char* sheet, int width,
                                 int height) {
  return reported([&]() -> const char* {
    OIIO::ImageBuf all = wrapped(sheet, width, height);
    for (int k = 0; k < count; ++k) {
      const int x = shape.gap + k % shape.columns * (shape.tile_width + shape.gap);
      const int y = shape.gap + k / shape.columns * (shape.tile_height + shape.label_height + shape.gap);
      const OIIO::ROI room(0, shape.tile_width, 0, shape.tile_height, 0, 1, 0, 3);
      const OIIO::ImageBuf scaled = OIIO::ImageBufAlgo::resize(wrapped(tiles[k].pixels, tiles[k].width, tiles[k].height), "box", 0, room);
      if (!OIIO::ImageBufAlgo::paste(all, x, y, 0, 0, scaled)) return say(all.geterror());
      const int size = shape.label_height * 2 / 3;
      write_text(all, x, y + shape.tile_height + size + 2, fitting(tiles[k].label, shape.tile_width, size), size);
    }
    return nullptr;
  });
}

const char* relume_encode_png(const unsigned char* pixels, int width, int height, int channels, relume::PictureBytes* take, void* context) {
  return reported([&]() -> const char* {
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto out = OIIO::ImageOutput::create("png", &memory);
    if (!out) return say(OIIO::geterror());
    OIIO::ImageSpec spec(width, height, channels, OIIO::TypeUInt8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("oiio:UnassociatedAlpha", 1);  // the colours are divided by alpha already
    if (channels == 2 || channels == 4) spec.alpha_channel = channels - 1;
    if (!out->open("memory.png", spec) || !out->write_image(OIIO::TypeUInt8, pixels) || !out->close()) return say(out->geterror());
    take(context, bytes.data(), bytes.size());
    return nullptr;
  });
}

const char* relume_decode_picture(const char* file, const char* reader, relume::PictureMemory* room, void* context) {
  return reported([&]() -> const char* {
    OIIO::attribute("try_all_readers", 0);
    const auto in = OIIO::ImageInput::create(reader);
    if (!in) return say(OIIO::geterror());
    OIIO::ImageSpec spec, wish;
    wish.attribute("oiio:UnassociatedAlpha", 1);  // textures are wanted as stored, not multiplied by alpha
    if (!in->open(file, spec, wish)) return say(in->geterror());
    if (const char* const refused = objection(spec)) return refused;
    float* const values = room(context, {spec.width, spec.height, spec.nchannels, spec.alpha_channel, is_srgb(spec, reader)});
    if (!in->read_image(0, 0, 0, spec.nchannels, OIIO::TypeFloat, values)) return say(in->geterror());
    return nullptr;
  });
}
