// A rectangle of pixels: the half-open form of OpenEXR's data and display windows.
#pragma once

#include <cstdint>

namespace relume {

struct Window {
  int min_x = 0, min_y = 0;  ///< first column and row
  int max_x = 0, max_y = 0;  ///< one past the last (OpenEXR's own windows include the last)

  int width() const { return max_x - min_x; }
  int height() const { return max_y - min_y; }
  std::int64_t pixels() const { return std::int64_t(width()) * height(); }
  bool empty() const { return max_x <= min_x || max_y <= min_y; }
  bool operator==(const Window&) const = default;
};

}  // namespace relume
