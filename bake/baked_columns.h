// The channels of a baked G-buffer: what each is called, how it is stored, and what of a point it holds.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "bake/surface_point.h"
#include "gbuffer/exr_file.h"

namespace relume {

/// A pixel of one of the parts.
struct BakedSample {
  SurfacePoint point;
  double depth = 0;                         ///< along the camera's axis
  std::uint32_t triangle = 0;               ///< position in Mesh::triangles, and in the part `facets`
  double u = 0, v = 0;                      ///< weights of the triangle's second and third vertex
  std::array<std::uint32_t, 3> vertices{};  ///< positions in Mesh::vertices, and in the part `vertices`
};

struct BakedColumn {
  Channel channel;
  double (*value)(const BakedSample&);
};

/// Of all three parts: position, normals, coverage, ids, and what the mesh's file tells. `halves`: normals and colours in 16 bits.
std::vector<BakedColumn> surface_columns(const Mesh& mesh, bool halves);
/// Of pixels beside those: depth, triangle, barycentrics.
std::vector<BakedColumn> pixel_columns(const Mesh& mesh, bool halves);
/// Of facets beside those: the numbers of their vertices.
std::vector<BakedColumn> facet_columns(const Mesh& mesh, bool halves);

/// Columns of as many samples as a band has, ready to write.
class BakedBand {
 public:
  BakedBand(const std::vector<BakedColumn>& columns, std::size_t samples);

  void put(std::size_t i, const BakedSample& sample);
  std::vector<const void*> samples() const;

 private:
  const std::vector<BakedColumn>& columns_;
  std::vector<std::vector<std::uint32_t>> bits_;  ///< floats' too; 0 is nothing in both
};

}  // namespace relume
