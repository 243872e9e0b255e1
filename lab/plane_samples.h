// A BRDF along the plane of incidence, sampled as finely as it bends, so that a sharp lobe is smooth and its tip is not missed.
#pragma once

#include <vector>

#include "lab/arrangement.h"
#include "lab/measure.h"

namespace relume {

struct PlaneSample {
  double angle;  ///< of the moving direction, degrees (in_plane)
  DirectionPair pair;
  Reflectance value;
};

/// In the order of angles, within 90 degrees to either side.
std::vector<PlaneSample> plane_samples(const Brdf& brdf, const Arrangement& arrangement, const Measure& measure);

struct Tip {
  double angle, value;
  bool bounded;  ///< else f_r grows towards the horizon without end, and this is its highest away from it
};

/// The highest sample of a part.
Tip tip_of(const std::vector<PlaneSample>& samples, const Measure& measure, LobePart part);

}  // namespace relume
