// The surface that the positions around a pixel make.
#pragma once

#include <glm/vec3.hpp>

#include "gbuffer/ailments/row.h"

namespace relume {

/// Of a row that has positions.
class Neighbourhood {
 public:
  explicit Neighbourhood(const Row& row);

  /// The normal (world, unit, of either side) where the positions beside, above and below go on as one smooth surface; else zero.
  glm::dvec3 normal_at(int column) const;

 private:
  glm::dvec3 at(int column, int down) const;
  glm::dvec3 smooth_step(const glm::dvec3& before, const glm::dvec3& centre, const glm::dvec3& after) const;

  const Row& row_;
  const double finest_;  ///< step, as a share of the position, that is more than rounding
  const float* rows_[3][3];
};

}  // namespace relume
