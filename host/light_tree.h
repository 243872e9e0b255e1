// Lights that nothing bounds, as a tree of clusters: each with a few lights that may stand in for it and what is needed to bound their error
// (host/light_cuts.h). Made once for a rig.
#pragma once

#include <span>
#include <vector>

#include "host/frame.h"

namespace relume {

/// Lights that stand in for a cluster, with the same sum of intensities and the same first moment in each channel; and by how much the higher
/// moments of intensity about the centre they are compared at differ. count 0: there are none.
struct StandIns {
  int first = 0, count = 0;  ///< records
  float second[3];           ///< sum of intensity times squared distance, of the lights and of those that stand in
  float uneven[3];           ///< Frobenius norm of the trace-free part of the difference between the second moments
  float third[3];            ///< sum of intensity times cubed distance, of both
  float width[3];            ///< intensity times the most that either's standard deviation is along any axis
};

struct LightCluster {
  float centre[3], radius;  ///< a ball that holds the lights and what stands in for them
  float intensity[3];       ///< sum
  StandIns one;             ///< one for each channel, in its centroid; or one for all where they coincide
  StandIns four;            ///< in a tetrahedron that has the lights' second moments too
  int first_child = -1;     ///< of two; -1: a leaf
  int begin = 0, end = 0;   ///< lights in order(), of this cluster
};

class LightTree {
 public:
  LightTree() = default;
  /// Of those lights in [begin[0], begin[LIGHT_COUNT]) that no cone, range or other falloff limits. None where they are too few to gain anything, or
  /// one has less than no intensity. What stands in is appended to `records`, as point lights.
  LightTree(std::vector<LightRecord>& records, std::span<const int, LIGHT_COUNT + 1> begin);

  bool empty() const { return clusters_.empty(); }
  /// The root is the first.
  std::span<const LightCluster> clusters() const { return clusters_; }
  /// The lights' record numbers, cluster by cluster.
  std::span<const int> order() const { return order_; }

  /// Whether the tree takes care of such a light.
  static bool takes(const LightRecord& light, int type);

 private:
  void split(int cluster, std::span<const LightRecord> records);

  std::vector<LightCluster> clusters_;
  std::vector<int> order_;
};

}  // namespace relume
