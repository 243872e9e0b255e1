// For each block of a band's pixels the lights that can reach it: culling by super-tile, tile and cell, in world space from the pixels' own
// positions and normals (tiles as in Olsson, Billeter and Assarsson 2012, "Clustered Deferred and Forward Shading"). Kernels that walk a list give
// the same bits as those that walk all lights: what is left out would have added nothing.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "gbuffer/planes.h"
#include "host/frame.h"
#include "host/frame_bounds.h"
#include "host/light_cuts.h"
#include "host/light_reach.h"

namespace relume {

/// Lights made ready to be asked which pixels they reach: once for a rig, whatever the number of bands.
struct SortedLights {
  /// Lights that one sphere stands for when a super-tile is asked: as many as one look at their own spheres pays for.
  static constexpr int clustered = 32;

  SortedLights() = default;
  /// The lights [begin[0], begin[LIGHT_COUNT]).
  SortedLights(std::span<const LightRecord> lights, std::span<const int, LIGHT_COUNT + 1> begin) : SortedLights(lights, begin, {}) {}
  /// But those that a tree takes care of.
  SortedLights(std::span<const LightRecord> lights, std::span<const int, LIGHT_COUNT + 1> begin, const LightTree& tree);

  LightReach reach;    ///< neighbours in space together
  LightReach spheres;  ///< around each `clustered` of them
  /// Boxes around pixels are split where they are longer: some half a light's reach, from where on lights fit into what is empty of a box. A power of
  /// two, so that bounds can be kept while lights change (host/frame_bounds.h).
  float widest_box = 0;
};

class LightLists {
 public:
  struct List;
  struct Listed;

  /// Nothing is listed: every light is met by every pixel.
  LightLists() = default;

  /// Lists the lights for the pixels that are bounded. At most `most` numbers are kept: where lights are dense, larger groups of pixels share a
  /// list. Returns what Frame::lists is to be: 0 where nothing can be culled, or no list fits.
  int add(FrameBounds& bounds, const SortedLights& lights, std::size_t most);
  /// With cuts through a light tree, tile by tile, behind the lights that are listed. Where they do not fit, 0: every light is met.
  int add(FrameBounds& bounds, const SortedLights& lights, const LightCuts& cuts, std::size_t most);

  /// Nothing is listed any more; the memory stays, for the lights of another moment.
  void clear() { size_ = 1; }

  /// Numbers that may be kept beside these planes: a quarter of the memory that they take.
  static std::size_t room_beside(const Planes& planes) { return planes.bytes() / sizeof(int) / 4; }

  /// The same where there are cuts, which hundreds of stand-ins pass: eight times as much memory as the planes take.
  static std::size_t room_for_cuts(const Planes& planes) { return 8 * planes.bytes() / sizeof(int); }

  /// What the kernels read: for each block the positions in it where its list begins and ends, and the lists, light numbers ascending.
  std::span<const int> numbers() const { return {numbers_.get(), size_}; }

 private:
  int append(const PixelCells& pixels, const std::vector<Listed>& listed);
  int add_lists(FrameBounds& bounds, const SortedLights& lights, const LightCuts* cuts, std::size_t most);

  std::unique_ptr<int[]> numbers_ = std::make_unique<int[]>(1);  // a Frame whose `lists` is 0 has none
  std::size_t capacity_ = 1, size_ = 1;
};

/// How many lights a pixel of the frame meets in the mean, at least one: what a launch's work is reckoned by.
std::int64_t lights_met(const Frame& frame, std::span<const int> lists);

}  // namespace relume
