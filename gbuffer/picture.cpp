// The sRGB curve of IEC 61966-2-1, and the loading of the module that knows the file formats.
#include "gbuffer/picture.h"

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include "gbuffer/error.h"
#include "gbuffer/input_stream.h"
#include "gbuffer/picture_module.h"
#include "gbuffer/printable.h"
#include "gbuffer/whole_file.h"

namespace relume {
namespace fs = std::filesystem;
namespace {

constexpr const char* module_name = "relume_picture.so";

void* load_module(const std::string& place, ErrorKind kind) {
  static void* const module = [] {
    std::error_code unknown;
    const fs::path folder = fs::read_symlink("/proc/self/exe", unknown).parent_path();
    if (folder.empty()) return static_cast<void*>(nullptr);  // never from the working folder, where anybody may have put a module
    // Beside the program; one up from tests and benchmarks in a build tree; where an installation puts it.
    for (const fs::path& candidate : {folder, folder / "..", folder / "../lib/relume"})
      if (fs::exists(candidate / module_name))
        if (void* const found = dlopen((candidate / module_name).c_str(), RTLD_NOW | RTLD_LOCAL)) return found;
    return static_cast<void*>(nullptr);
  }();
  if (module) return module;
  const char* const fault = dlerror();
  throw Error(kind, place + ": pictures need " + module_name + " beside the program or in ../lib/relume, and OpenImageIO" +
                        (fault ? " (" + printable(fault) + ")" : ""));
}

template <class Function>
Function* function_named(const char* name, const std::string& place, ErrorKind kind) {
  void* const found = dlsym(load_module(place, kind), name);
  if (!found) throw Error(kind, place + ": " + module_name + " is of another version (no " + name + ")");
  return reinterpret_cast<Function*>(found);
}

float linear_of(float encoded) { return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f); }

std::uint8_t alpha_code(float alpha) { return std::uint8_t(std::lround(std::clamp(std::isnan(alpha) ? 0.0f : alpha, 0.0f, 1.0f) * 255)); }

std::vector<unsigned char> encode(const Picture& picture, double exposure_stops) {
  const float gain = float(std::exp2(exposure_stops));
  const std::size_t channels = std::size_t(picture.channels), colours = std::min<std::size_t>(channels, 3);
  std::vector<unsigned char> codes(picture.values.size());
  for (std::size_t i = 0; i < codes.size(); i += channels) {
    const float alpha = channels == 4 ? picture.values[i + 3] : 1;
    const float scale = alpha > 0 ? gain / alpha : gain;  // PNG stores colours that are not multiplied by alpha
    for (std::size_t c = 0; c < colours; ++c) codes[i + c] = srgb_code(picture.values[i + c] * scale);
    if (channels == 4) codes[i + 3] = alpha_code(alpha);
  }
  return codes;
}

/// OpenImageIO's name of the reader for an extension; null where we offer none.
const char* reader_for(std::string extension) {
  std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  constexpr std::array<std::array<const char*, 2>, 8> readers = {{{".png", "png"},
                                                                  {".jpg", "jpeg"},
                                                                  {".jpeg", "jpeg"},
                                                                  {".tif", "tiff"},
                                                                  {".tiff", "tiff"},
                                                                  {".hdr", "hdr"},
                                                                  {".tga", "targa"},
                                                                  {".pfm", "pnm"}}};
  for (const auto& [known, reader] : readers)
    if (extension == known) return reader;
  return nullptr;
}

void linearise(Picture& picture, int alpha_channel) {
  for (std::size_t i = 0; i < picture.values.size(); ++i)
    if (int(i % std::size_t(picture.channels)) != alpha_channel) picture.values[i] = linear_of(picture.values[i]);
}

}  // namespace

std::uint8_t srgb_code(float linear) {
  static const std::array<float, 255> bounds = [] {
    std::array<float, 255> all{};
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = linear_of((float(i) + 0.5f) / 255);
    return all;
  }();
  if (std::isnan(linear)) return 0;
  return std::uint8_t(std::upper_bound(bounds.begin(), bounds.end(), linear) - bounds.begin());
}

void write_png(const fs::path& file, const Picture& picture, double exposure_stops, bool overwrite) {
  const bool fits = picture.values.size() == std::size_t(picture.width) * std::size_t(picture.height) * std::size_t(picture.channels);
  if (!fits) throw Error(ErrorKind::internal, printable(file.native()) + ": a picture without all its pixels");
  if (!overwrite && fs::exists(file)) WholeFile(file, overwrite);  // refuses before the work
  write_png(file, CodedPicture{picture.width, picture.height, picture.channels, encode(picture, exposure_stops)}, overwrite);
}

void write_png(const fs::path& file, const CodedPicture& picture, bool overwrite) {
  const std::string place = printable(file.native());
  const bool fits = picture.width > 0 && picture.height > 0 && (picture.channels == 1 || picture.channels == 3 || picture.channels == 4) &&
                    picture.codes.size() == std::size_t(picture.width) * std::size_t(picture.height) * std::size_t(picture.channels);
  if (!fits) throw Error(ErrorKind::internal, place + ": a PNG needs pixels of 1, 3 or 4 channels");
  WholeFile out(file, overwrite);  // refuses before the work
  auto* const encode_png = function_named<EncodePng>("relume_encode_png", place, ErrorKind::output);
  std::vector<char> bytes;
  PictureBytes* const take = [](void* context, const void* data, std::size_t size) {
    static_cast<std::vector<char>*>(context)->assign(static_cast<const char*>(data), static_cast<const char*>(data) + size);
  };
  if (const char* const fault = encode_png(picture.codes.data(), picture.width, picture.height, picture.channels, take, &bytes))
    throw Error(ErrorKind::output, place + ": " + printable(fault));
  out.write(bytes.data(), bytes.size());
  out.commit();
}

void compose_sheet(std::span<const SheetTile> tiles, const SheetShape& shape, CodedPicture& sheet) {
  auto* const compose = function_named<ComposeSheet>("relume_compose_sheet", "contact sheet", ErrorKind::output);
  if (const char* const fault = compose(tiles.data(), int(tiles.size()), shape, sheet.codes.data(), sheet.width, sheet.height))
    throw Error(ErrorKind::output, std::string("contact sheet: ") + printable(fault));
}

Picture read_picture(const fs::path& file) {
  const std::string place = InputStream(file).name();  // a regular file that can be read: no URL, no device
  const char* const reader = reader_for(file.extension());
  if (!reader) throw Error(ErrorKind::input, place + ": no picture format is known by this extension (png, jpg, tif, hdr, tga, pfm)");
  auto* const decode = function_named<DecodePicture>("relume_decode_picture", place, ErrorKind::input);
  struct Result {
    Picture picture;
    PictureShape shape{};
  } result;
  PictureMemory* const room = [](void* context, const PictureShape& shape) {
    Result& to = *static_cast<Result*>(context);
    to.shape = shape;
    to.picture = {shape.width, shape.height, shape.channels, {}};
    to.picture.values.resize(std::size_t(shape.width) * std::size_t(shape.height) * std::size_t(shape.channels));
    return to.picture.values.data();
  };
  // Absolute: OpenImageIO takes some beginnings of a path for a protocol.
  if (const char* const fault = decode(fs::absolute(file).c_str(), reader, room, &result))
    throw Error(ErrorKind::input, place + ": " + printable(fault));
  if (result.shape.srgb) linearise(result.picture, result.shape.alpha_channel);
  return std::move(result.picture);
}

}  // namespace relume
