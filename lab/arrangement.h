// Which of the two directions stands still while the other goes over the hemisphere, and where: the important directions of a figure.
#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "lab/brdf.h"

namespace relume {

/// A direction in the plane of incidence (y = 0), `angle` degrees from the normal, positive towards +x.
glm::dvec3 in_plane(double angle);

struct NamedDirection {
  std::string name;  ///< "R_v", as gnuplot's markup has it
  double angle;      ///< degrees from the normal, as in_plane's
};

/// The direction that stands still lies at -angle, so that its mirror direction lies at +angle.
struct Arrangement {
  bool light_stands = false;  ///< else the view direction
  double angle = 45;          ///< degrees from the normal, 0 to below 90

  /// The pair with the direction that moves.
  DirectionPair with(const glm::dvec3& moving) const;
  /// View and light exchanged.
  Arrangement swapped() const { return {!light_stands, angle}; }
  const char* standing() const { return light_stands ? "light" : "view"; }
  const char* moving() const { return light_stands ? "view" : "light"; }

  /// n, the direction that stands, its mirror direction; with a moving one at `marked`: that, its mirror direction, and h. Those that coincide are
  /// one.
  std::vector<NamedDirection> directions(const double* marked) const;
};

}  // namespace relume
