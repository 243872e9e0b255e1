// An environment: incident radiance from every direction, bilinear between the texels of a latitude-longitude image, as renderers take it.
#pragma once

#include <array>
#include <filesystem>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "host/environment_mapping.h"

namespace relume {

/// Column j looks at azimuth 2 pi (j + shift)/width, row i at the angle pi (i + shift)/rows from the pole, where shift and rows follow from the
/// mapping.
struct EnvironmentMap {
  int width = 0, height = 0;
  bool rows_on_border = false, columns_on_border = false;
  std::vector<std::array<float, 3>> radiance;  ///< row by row from the pole at the top, W/(m^2 sr)

  double column_shift() const { return columns_on_border ? 0 : 0.5; }
  double row_shift() const { return rows_on_border ? 0 : 0.5; }
  /// Of texel heights from pole to pole.
  int row_steps() const { return rows_on_border ? height - 1 : height; }
  double polar_angle(int row) const;
  double azimuth(int column) const;
  /// In the map's own frame (EnvironmentMapping::light_from_map).
  glm::dvec3 direction(int row, int column) const;

  /// Where a direction of the map's own frame meets the image: bilinear between the texels' centres, W/(m^2 sr).
  glm::dvec3 towards(const glm::dvec3& direction) const;

  /// Integral over the sphere of the weight that each texel of a row has in the interpolated radiance, sr: they sum to 4 pi over all texels.
  std::vector<double> solid_angles() const;
};

/// Reads an EXR, or a picture that OpenImageIO knows (HDR). Error{input}: no latitude-longitude image, or a radiance that is negative or not finite.
EnvironmentMap read_environment(const std::filesystem::path& file, const EnvironmentMapping& mapping);

/// The same from an image in memory, for which `place` stands in messages.
EnvironmentMap environment_of(int width, int height, std::vector<std::array<float, 3>> radiance, const EnvironmentMapping& mapping,
                              const std::string& place);

}  // namespace relume
