// When a mesh is lit: at each pixel (Phong interpolation), at its vertices (Gouraud) or once a facet. Which lobes light it is another matter.
#pragma once

#include <vector>

#include "gbuffer/exr_file.h"
#include "gbuffer/gbuffer.h"
#include "gbuffer/planes.h"
#include "gbuffer/reading.h"
#include "host/output_layout.h"

namespace relume {

enum class Interpolation {
  phong,    ///< normals are interpolated, pixels are lit (Phong 1975)
  gouraud,  ///< vertices are lit, their radiance is interpolated (Gouraud 1971)
  flat      ///< facets are lit at their middle, with their own normal
};

/// The radiance of a mesh's vertices or facets, from the lists that relume bake stores beside the pixels.
class MeshRadiance {
 public:
  /// `pixels`: how the file's pixels are read, with all roles that shading needs. Error{input} where the file has no such lists, Error{memory} where
  /// they do not fit. The file and the layout outlive it.
  MeshRadiance(const ExrFile& file, const Reading& pixels, Interpolation interpolation, const OutputLayout& layout, std::int64_t memory);

  /// Of the samples to be lit.
  const Reading& reading() const { return reading_; }
  /// Takes a band of the list that was lit, with the layout's planes.
  void take(const Window& band, const Planes& lit);
  /// The layout's planes of a band of pixels, but for alpha; 0 where `gbuffer` shows no surface.
  void interpolate(const GBuffer& gbuffer, Planes& out) const;

 private:
  void read_facets();
  std::uint32_t checked(std::uint32_t number, std::size_t count, const char* what) const;

  const ExrFile& file_;
  const Interpolation interpolation_;
  const OutputLayout& layout_;
  const int pixels_part_;
  const Reading reading_;
  std::vector<std::uint32_t> facets_;         ///< three vertices each; empty where facets are lit
  std::vector<std::vector<float>> radiance_;  ///< of each plane of the layout
};

}  // namespace relume
