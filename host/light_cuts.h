// Which clusters of a light tree stand in for their lights on some pixels, so that no pixel's radiance is off by more than a share of itself:
// lightcuts (Walter, Fernandez, Arbree, Bala, Donikian and Greenberg 2005, "Lightcuts") with the sum of all clusters' errors bounded in place of each
// alone.
#pragma once

#include <span>
#include <vector>

#include "host/light_tree.h"
#include "host/pixel_patch.h"

namespace relume {

class LightCuts {
 public:
  /// `programs`: by number. Everything given outlives it. `error`: share of each channel's radiance, above 0.
  LightCuts(const LightTree& tree, std::span<const Choice> programs, std::span<const float> tables, double error);

  /// How far normals may spread in a patch (add_patches): a highlight is bounded by the brightest pixel that a patch may have.
  float most_turn() const { return most_turn_; }
  /// Adds the records, lights and stand-ins, that light these patches.
  void add_cut(std::span<const PixelPatch> patches, std::vector<int>& numbers) const;

 private:
  const LightTree& tree_;
  std::span<const Choice> programs_;
  std::span<const float> tables_;
  float error_, most_turn_;
  std::vector<int> top_;  ///< clusters that all cuts start from
};

}  // namespace relume
