// Neighbourhood: the cross product of what the positions do along a row and down a column.
#include "gbuffer/ailments/neighbourhood.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace relume {

using glm::dvec3;

namespace {

/// Numbers move in steps of 2^-10 (half) or 2^-23 of themselves; a direction takes some of these.
double finest_step(SampleType type) { return type == SampleType::half_float ? 0x1p-6 : 0x1p-19; }

}  // namespace

Neighbourhood::Neighbourhood(const Row& row) : row_(row), finest_(finest_step(row.reading.roles.at("position").types.front())) {
  for (int down = -1; down <= 1; ++down)
    for (int c = 0; c < 3; ++c) rows_[down + 1][c] = row.stored("position", c, down);
}

dvec3 Neighbourhood::normal_at(int column) const {
  if (column < 1 || column + 1 >= row_.width || !rows_[0][0] || !rows_[2][0]) return dvec3(0);
  const dvec3 centre = at(column, 0);
  const dvec3 across = smooth_step(at(column - 1, 0), centre, at(column + 1, 0)), down = smooth_step(at(column, -1), centre, at(column, 1));
  if (across == dvec3(0) || down == dvec3(0)) return dvec3(0);
  const dvec3 normal = row_.frame.position_in_world(glm::cross(across, down)) - row_.frame.position_in_world(dvec3(0));
  return glm::dot(normal, normal) > 0 ? glm::normalize(normal) : dvec3(0);
}

dvec3 Neighbourhood::at(int column, int down) const {
  const auto& r = rows_[down + 1];
  return {r[0][column], r[1][column], r[2][column]};
}

/// From one neighbour to the other, if both sides go on alike (a step in depth makes one much longer); else zero.
dvec3 Neighbourhood::smooth_step(const dvec3& before, const dvec3& centre, const dvec3& after) const {
  const dvec3 from = centre - before, to = after - centre;
  const double f = glm::length(from), t = glm::length(to);
  const bool straight = t < 2 * f && f < 2 * t && glm::dot(from, to) > 0.9 * f * t;
  return straight && t > finest_ * glm::length(centre) ? from + to : dvec3(0);
}

}  // namespace relume
