// Measure: f_r or f_r n.l, in one channel.
#include "lab/measure.h"

namespace relume {

const char* name_of(LobePart part) { return part == LobePart::total ? "total" : part == LobePart::diffuse ? "diffuse" : "specular"; }

const char* name_of(ColourChannel channel) {
  const char* names[] = {"red", "green", "blue", "luminance"};
  return names[int(channel)];
}

glm::dvec3 part_of(const Reflectance& value, LobePart part) {
  return part == LobePart::total ? value.total() : part == LobePart::diffuse ? value.diffuse : value.specular;
}

double in_channel(const glm::dvec3& colour, ColourChannel channel) {
  switch (channel) {
    case ColourChannel::r:
      return colour.r;
    case ColourChannel::g:
      return colour.g;
    case ColourChannel::b:
      return colour.b;
    case ColourChannel::luminance:
      break;
  }
  return 0.2126 * colour.r + 0.7152 * colour.g + 0.0722 * colour.b;  // ITU-R BT.709
}

double Measure::operator()(const Reflectance& value, double n_l, LobePart part) const {
  const double reflectance = in_channel(part_of(value, part), channel);
  return quantity == Quantity::reflectance ? reflectance : n_l > 0 ? reflectance / n_l : 0;
}

std::string Measure::title() const { return std::string(quantity == Quantity::f_r ? "f_r, " : "f_r n·l, ") + name_of(channel) + " (1/sr)"; }

}  // namespace relume
