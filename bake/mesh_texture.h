// A texture of a mesh: scene-linear or plain numbers, looked up at texture coordinates.
#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string>

#include "gbuffer/picture.h"

namespace relume {

/// What is beyond 0..1.
enum class Wrap { repeat, mirror, clamp };

class MeshTexture {
 public:
  /// `colour`: values are colours, on the sRGB curve where the format stores 8 bits; else they are taken as stored. Error{input} for a picture that
  /// cannot be read.
  MeshTexture(const std::filesystem::path& file, bool colour, Wrap across, Wrap down);
  /// The same for a picture in memory, in the format of this extension ("png").
  MeshTexture(std::span<const unsigned char> encoded, const std::string& extension, bool colour, Wrap across, Wrap down);

  /// Bilinear between the texels' centres; v counts upwards.
  glm::dvec3 at(const glm::dvec2& uv) const;

 private:
  glm::dvec3 texel(long x, long y) const;

  Picture picture_;
  Wrap across_, down_;
};

}  // namespace relume
