// The important directions of the lecture, in the plane of incidence.
#include "lab/arrangement.h"

#include <cmath>
#include <numbers>

namespace relume {
namespace {

constexpr double same = 0.01;  // degrees: less than a figure can show

void add(std::vector<NamedDirection>& directions, const std::string& name, double angle) {
  for (NamedDirection& d : directions)
    if (std::abs(d.angle - angle) < same) {
      d.name += " = " + name;
      return;
    }
  directions.push_back({name, angle});
}

}  // namespace

glm::dvec3 in_plane(double angle) {
  const double radians = angle * std::numbers::pi / 180;
  return {std::sin(radians), 0, std::cos(radians)};
}

DirectionPair Arrangement::with(const glm::dvec3& moving) const {
  const glm::dvec3 standing = in_plane(-angle);
  return light_stands ? DirectionPair{standing, moving} : DirectionPair{moving, standing};
}

std::vector<NamedDirection> Arrangement::directions(const double* marked) const {
  const std::string standing = light_stands ? "l" : "v", moving = light_stands ? "v" : "l";
  std::vector<NamedDirection> all;
  add(all, "n", 0);
  add(all, standing, -angle);
  add(all, "R_" + standing, angle);
  if (!marked) return all;
  add(all, moving, *marked);
  add(all, "R_" + moving, -*marked);
  add(all, "h", (*marked - angle) / 2);
  return all;
}

}  // namespace relume
