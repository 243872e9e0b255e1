// Pixels that have a surface by every other sign, and no normal.
#include <cmath>
#include <glm/geometric.hpp>

#include "gbuffer/ailments/ailment.h"

namespace relume {
namespace {

/// The tails of a filter leave next to nothing of a normal around a silhouette: only what is exactly zero counts where layers are filtered.
float longest_zero(const Reading& reading) { return reading.position_premultiplied ? 0 : 1e-6f; }

/// A place other than the origin, in front of the background, covered if the file says what is.
void look(const Row& row, std::span<Tally> tallies) {
  if (row.normal.empty() || row.place.empty()) return;
  const float *const depth = row.stored("depth"), *const coverage = row.stored("coverage");
  const auto stored = row.components("position");
  for (std::size_t i = 0; i < row.normal.size(); ++i) {
    const glm::dvec3 place{stored[0][i], stored[1][i], stored[2][i]};
    if (!std::isfinite(place.x + place.y + place.z) || place == glm::dvec3(0)) continue;
    if (depth && !(std::abs(depth[i]) < row.reading.background_depth)) continue;
    if (coverage && !(coverage[i] > 0)) continue;
    ++tallies[0].judged;
    if (row.length[i] <= longest_zero(row.reading)) tallies[0].add(row.min_x + int(i), row.y);
  }
}

void examine(const Patient& patient, std::vector<Check>& checks, std::vector<Finding>&) {
  if (!patient.has("normal") || !patient.has("position")) return;
  const std::string layer = patient.layer("normal").layer;
  const auto conclude = [layer](std::span<const Tally> tallies, std::vector<Finding>& findings) {
    if (tallies[0].pixels)
      findings.push_back(
          {"", Severity::defect, layer, tallies[0],
           "the normal is zero at " + std::to_string(tallies[0].pixels) + " pixels that have a position (" + share_in_words(tallies[0]) + ")",
           "these pixels count as background and stay black", "--map normal=LAYER takes another layer"});
  };
  checks.push_back({{}, 1, look, conclude});
}

}  // namespace

extern const Ailment ailment_zero_normals;
const Ailment ailment_zero_normals{"zero_normals", "surfaces without a normal", examine};

}  // namespace relume
