// An image that a material's parameter is read from, by the texture coordinates of the G-buffer.
#pragma once

#include <vector>

#include "gbuffer/picture.h"
#include "host/materials.h"

namespace relume {

/// Texel centres at (i + 0.5)/n, repeated beyond 0..1.
class Texture {
 public:
  explicit Texture(const TextureValue& value);
  /// Channel c (the last channel stands in for those beyond it) at u, v.
  double sample(double u, double v, int c) const;

 private:
  double texel(long x, long y, int c) const;

  Picture picture_;
  bool bilinear_, v_down_;
};

/// The texture of a value, read once a process. Error{input}.
const Texture& texture_of(const TextureValue& value);

}  // namespace relume
