// A rectangle of pixels: the half-open form of OpenEXR's data and display windows.
#pragma once

#include <algorithm>
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

/// What both cover; empty() where they have no pixel in common.
inline Window intersection(const Window& a, const Window& b) {
  return {std::max(a.min_x, b.min_x), std::max(a.min_y, b.min_y), std::min(a.max_x, b.max_x), std::min(a.max_y, b.max_y)};
}

/// The window and what lies within `by` pixels of it, as far as `limit` reaches.
inline Window grown(const Window& window, int by, const Window& limit) {
  return intersection({window.min_x - by, window.min_y - by, window.max_x + by, window.max_y + by}, limit);
}

}  // namespace relume
