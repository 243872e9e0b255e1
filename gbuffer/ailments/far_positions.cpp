// Positions so large that their squares leave single precision.
#include <algorithm>
#include <cmath>

#include "gbuffer/ailments/ailment.h"
#include "gbuffer/three_digits.h"

namespace relume {
namespace {

void look(const Row& row, std::span<Tally> tallies) {
  constexpr double farthest = 1e18;  // its square, as distances are taken, is near the largest float, 3e38
  for (std::size_t i = 0; i < row.place.size(); ++i) {
    if (row.shown[i] == Shown::nothing) continue;
    const glm::dvec3& p = row.place[i];
    const double largest = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    ++tallies[0].judged;
    if (largest > farthest) tallies[0].add(row.min_x + int(i), row.y, largest);
  }
}

void examine(const Patient& patient, std::vector<Check>& checks, std::vector<Finding>&) {
  if (!patient.has("position")) return;
  const auto conclude = [layer = patient.layer("position").layer](std::span<const Tally> tallies, std::vector<Finding>& findings) {
    if (tallies[0].pixels)
      findings.push_back({"", Severity::defect, layer, tallies[0],
                          "positions reach " + three_digits(tallies[0].worst) + " (" + share_in_words(tallies[0]) + " beyond 1e18)",
                          "distances to lights overflow, and these pixels stay black", "--map position=LAYER takes another layer"});
  };
  checks.push_back({{}, 1, look, conclude});
}

}  // namespace

extern const Ailment ailment_far_positions;
const Ailment ailment_far_positions{"far_positions", "positions beyond single precision", examine};

}  // namespace relume
