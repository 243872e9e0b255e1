// Many integrals over rectangles at once, each refined where it needs it: Genz and Malik 1980, "Remarks on algorithm 006: An adaptive algorithm for
// numerical integration over an N-dimensional rectangular region", in the plane.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace relume {

struct Rectangle {
  glm::dvec2 low, high;
};

/// What is integrated, side by side: two lobes of three channels.
using Values = std::array<double, 6>;

struct CubaturePoint {
  std::size_t integral;  ///< which of them
  glm::dvec2 at;
};
/// The values at points, in their order.
using Integrand = std::function<std::vector<Values>(std::span<const CubaturePoint>)>;

struct Integral {
  Values value{};
  Values error{};  ///< the sum over rectangles of how far the rules of degree 7 and 5 are apart: more than the error of the former, which is given
};

/// One integral for each of `domains`, a set of rectangles which shows every peak. The integrand is asked for many points at a time; rectangles are
/// halved until the error of each integral is below `tolerance`, or 2^18 points have been asked for.
std::vector<Integral> integrate(std::span<const std::vector<Rectangle>> domains, const Integrand& integrand, double tolerance);

}  // namespace relume
