// The channels of a relit image, and the planes of a band that hold them: the total and alpha first, then the layers asked for.
#pragma once

#include <string>
#include <vector>

namespace relume {

struct OutputLayout {
  static constexpr int total = 0, alpha = 3;              ///< planes
  std::vector<std::string> channels{"R", "G", "B", "A"};  ///< one for each plane
  int diffuse = -1, specular = -1, ambient = -1;          ///< the first of three planes, or -1: not wanted
  int lights = -1;                                        ///< of the first light; each light has three

  int planes() const { return int(channels.size()); }
  /// The total and what it is made of: those that every light adds to.
  int colours() const { return 1 + (diffuse >= 0) + (specular >= 0) + (ambient >= 0); }

  /// Three planes named "<layer>.R" and so on; the first of them.
  int add_colour(const std::string& layer) {
    const int first = planes();
    for (const char* channel : {".R", ".G", ".B"}) channels.push_back(layer + channel);
    return first;
  }
};

}  // namespace relume
