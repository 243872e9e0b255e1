// What figures compare: one baked mesh under one rig, lit at its vertices, at its facets and at its pixels.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "host/interpolation.h"
#include "host/materials.h"

namespace relume {

/// How a G-buffer is lit, whenever that is.
struct Lighting {
  std::vector<std::filesystem::path> rigs;
  Material material;
  std::string device;
};

struct LitImage {
  int width = 0, height = 0;
  std::array<std::vector<float>, 3> rgb;  ///< radiance, row by row from the top

  double luminance(std::size_t i) const { return 0.2126 * rgb[0][i] + 0.7152 * rgb[1][i] + 0.0722 * rgb[2][i]; }  // Rec. 709
};

LitImage lit(const std::filesystem::path& gbuffer, Interpolation interpolation, const Lighting& lighting);

/// The facet that each pixel shows; -1: none.
std::vector<std::int64_t> facets_of(const std::filesystem::path& gbuffer);

}  // namespace relume
