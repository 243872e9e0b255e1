// Which lights can reach which bounds of pixels: tests that never say no to a light that reaches, so that culling changes no bit of the image.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "host/frame.h"
#include "host/light_columns.h"
#include "host/pixel_cells.h"

namespace relume {

/// Lights as structure of arrays, tested many at a time.
class LightReach {
 public:
  LightReach() = default;
  /// The lights [begin[0], begin[LIGHT_COUNT]) of the records.
  LightReach(std::span<const LightRecord> lights, std::span<const int, LIGHT_COUNT + 1> begin) : LightReach(lights, begin, {}) {}
  /// But those of `others`, ascending numbers.
  LightReach(std::span<const LightRecord> lights, std::span<const int, LIGHT_COUNT + 1> begin, std::span<const int> others);

  std::size_t size() const { return count_; }
  /// Whether distance can put a light out of reach.
  bool any_bounded() const { return any_bounded_; }
  /// Half of the lights that have one have a longer reach; infinity where none has.
  float median_reach() const;

  /// Those that may reach a position within one of the boxes, whichever way the surface there faces. `kept` is overwritten, its memory used again:
  /// thousands of tiles ask.
  void near(std::span<const PixelBounds> boxes, LightReach& kept) const;
  /// The numbers of those that may light some pixel of one of the parts, in the lights' order, added to `numbers`.
  void add_lighting(std::span<const PixelBounds> parts, std::vector<int>& numbers) const;
  /// All numbers, added.
  void add_numbers(std::vector<int>& numbers) const { numbers.insert(numbers.end(), light_.data(), light_.data() + count_); }

  /// The same lights in an order that keeps neighbours together.
  LightReach in_space_order() const;
  /// Spheres around each `count` lights that follow one another. `count`: a multiple of `together`.
  LightReach spheres_around(int count) const;
  /// Of lights in space order, `count` of which each of `spheres` holds, those near, by number.
  void members_near(std::span<const PixelBounds> boxes, const LightReach& spheres, int count, LightReach& kept) const;

  /// Lights are tested by as many at most.
  static constexpr int together = 16;

 private:
  enum { x, y, z, w, range2, axis_x, axis_y, axis_z, cosine, sine, fields };  // of LightColumns
  using Values = std::array<float, fields>;

  void add(int light, const Values& values);
  void pick(std::span<const int> places, LightReach& kept) const;
  /// Fills the arrays up with lights that reach nothing, to a multiple of `together`.
  void pad();
  void disarm_padding();
  LightColumns columns() const;

  std::size_t count_ = 0;
  std::vector<int> light_;  ///< record numbers; this and the values are padded
  std::array<std::vector<float>, fields> values_;
  bool any_bounded_ = false, any_cone_ = false;
  std::vector<int> place_of_;  ///< of each light, by number, once they are in space order
};

}  // namespace relume
