// How many pixels have something, where, and which one shows it best.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "gbuffer/window.h"

namespace relume {

struct Tally {
  std::int64_t pixels = 0;  ///< that have it
  std::int64_t judged = 0;  ///< of those that could have it
  Window box;               ///< around the pixels
  int x = 0, y = 0;         ///< the worst pixel; of equals the first in reading order
  double worst = -std::numeric_limits<double>::infinity();
  double least = std::numeric_limits<double>::infinity(), greatest = -least;  ///< of whatever is measured
  std::uint8_t* marks = nullptr;                                              ///< where wanted: a byte for each pixel of `marked`, set to `mark`
  Window marked;
  std::uint8_t mark = 0;

  void add(int px, int py, double badness = 0) {
    grow({px, py, px + 1, py + 1});
    offer(px, py, badness);
    ++pixels;
    if (marks) marks[std::int64_t(py - marked.min_y) * marked.width() + px - marked.min_x] = mark;
  }

  /// Every pixel of a window, the first as the example.
  void add_all(const Window& window) {
    grow(window);
    offer(window.min_x, window.min_y, 0);
    pixels += window.pixels();
  }

  void measure(double value) {
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }

  void join(const Tally& other) {
    if (other.pixels) {
      grow(other.box);
      offer(other.x, other.y, other.worst);
    }
    pixels += other.pixels;
    judged += other.judged;
    least = std::min(least, other.least);
    greatest = std::max(greatest, other.greatest);
  }

  double share() const { return judged > 0 ? double(pixels) / double(judged) : 0; }

 private:
  void grow(const Window& w) {
    box = box.empty()
              ? w
              : Window{std::min(box.min_x, w.min_x), std::min(box.min_y, w.min_y), std::max(box.max_x, w.max_x), std::max(box.max_y, w.max_y)};
  }
  void offer(int px, int py, double badness) {
    const bool earlier = py < y || (py == y && px < x);
    if (badness > worst || (badness == worst && earlier)) x = px, y = py, worst = badness;
  }
};

}  // namespace relume
