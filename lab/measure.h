// What a figure shows of a BRDF's value: one number.
#pragma once

#include <string>

#include "lab/brdf.h"

namespace relume {

enum class LobePart { total, diffuse, specular };
enum class Quantity { f_r, reflectance };
enum class ColourChannel { r, g, b, luminance };

const char* name_of(LobePart part);
/// "luminance", "red"
const char* name_of(ColourChannel channel);

/// A part's reflectance f_r n.l in colour.
glm::dvec3 part_of(const Reflectance& value, LobePart part);

/// BT.709's luminance, or a channel.
double in_channel(const glm::dvec3& colour, ColourChannel channel);

struct Measure {
  Quantity quantity = Quantity::f_r;
  ColourChannel channel = ColourChannel::luminance;

  double operator()(const Reflectance& value, double n_l, LobePart part) const;
  /// "f_r (1/sr)", as gnuplot's markup has it.
  std::string title() const;
};

}  // namespace relume
