// MeshTexture: pictures through gbuffer/picture.h; those inside a mesh's file by way of a temporary one.
#include "bake/mesh_texture.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <glm/common.hpp>

#include "gbuffer/error.h"
#include "gbuffer/temporary_file.h"

namespace relume {
namespace {

/// read_picture() makes 8-bit values linear; those that are no colours want the stored ones back (IEC 61966-2-1).
float stored_of(float linear) { return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f; }

bool has_curve(const std::filesystem::path& file) { return file.extension() != ".hdr" && file.extension() != ".pfm"; }

Picture picture_from(const std::filesystem::path& file, bool colour) {
  Picture picture = read_picture(file);
  if (picture.width < 1 || picture.height < 1 || picture.channels < 1) throw Error(ErrorKind::input, file.string() + ": has no pixels");
  if (!colour && has_curve(file)) std::transform(picture.values.begin(), picture.values.end(), picture.values.begin(), stored_of);
  return picture;
}

Picture picture_from(std::span<const unsigned char> encoded, const std::string& extension, bool colour) {
  const TemporaryFile file('.' + extension);
  std::ofstream(file.path(), std::ios::binary).write(reinterpret_cast<const char*>(encoded.data()), std::streamsize(encoded.size()));
  return picture_from(file.path(), colour);
}

long wrapped(long i, long count, Wrap wrap) {
  if (wrap == Wrap::clamp) return std::clamp(i, 0L, count - 1);
  const long period = wrap == Wrap::mirror ? 2 * count : count, in_period = (i % period + period) % period;
  return in_period < count ? in_period : period - 1 - in_period;
}

}  // namespace

MeshTexture::MeshTexture(const std::filesystem::path& file, bool colour, Wrap across, Wrap down)
    : picture_(picture_from(file, colour)), across_(across), down_(down) {}

MeshTexture::MeshTexture(std::span<const unsigned char> encoded, const std::string& extension, bool colour, Wrap across, Wrap down)
    : picture_(picture_from(encoded, extension, colour)), across_(across), down_(down) {}

glm::dvec3 MeshTexture::texel(long x, long y) const {
  const std::size_t column = std::size_t(wrapped(x, picture_.width, across_)), row = std::size_t(wrapped(y, picture_.height, down_));
  const float* const p = picture_.values.data() + (row * std::size_t(picture_.width) + column) * std::size_t(picture_.channels);
  return picture_.channels < 3 ? glm::dvec3(p[0]) : glm::dvec3(p[0], p[1], p[2]);
}

glm::dvec3 MeshTexture::at(const glm::dvec2& uv) const {
  constexpr double farthest = 1e9;  // more than any texture has texels; beyond it a cast to long says nothing
  const double x = std::clamp(uv.x * picture_.width - 0.5, -farthest, farthest),
               y = std::clamp((1 - uv.y) * picture_.height - 0.5, -farthest, farthest);
  if (std::isnan(x) || std::isnan(y)) return texel(0, 0);
  const long left = long(std::floor(x)), top = long(std::floor(y));
  const glm::dvec3 upper = glm::mix(texel(left, top), texel(left + 1, top), x - double(left));
  const glm::dvec3 lower = glm::mix(texel(left, top + 1), texel(left + 1, top + 1), x - double(left));
  return glm::mix(upper, lower, y - double(top));
}

}  // namespace relume
