// Normals that point away from the viewer: flipped, or the backs of surfaces.
#include <cmath>
#include <glm/geometric.hpp>

#include "gbuffer/ailments/ailment.h"
#include "gbuffer/ailments/neighbourhood.h"

namespace relume {
namespace {

glm::dvec3 towards_viewer(const Camera& camera, const glm::dvec3& place) {
  return camera.projection == Camera::Projection::orthographic ? camera.backward() : glm::normalize(camera.eye() - place);
}

/// The surface's own normal, turned to the viewer, tells a flipped normal from one that a bump or a coarse mesh bends over the silhouette.
void look(const Row& row, std::span<Tally> tallies) {
  if (row.normal.empty() || row.place.empty() || !row.reading.camera) return;
  const Neighbourhood neighbourhood(row);
  for (std::size_t i = 0; i < row.normal.size(); ++i) {
    if (row.shown[i] != Shown::surface) continue;
    ++tallies[0].judged;
    const glm::dvec3 view = towards_viewer(*row.reading.camera, row.place[i]);
    const double facing = glm::dot(row.normal[i], view);
    if (facing >= 0) continue;
    const glm::dvec3 surface = neighbourhood.normal_at(int(i));
    constexpr double plainly = -0.5;  // 120 degrees off the surface's own side
    const bool flipped = surface == glm::dvec3(0) ? facing < plainly
                                                  : glm::dot(row.normal[i], surface) * glm::dot(surface, view) < 0 &&
                                                        std::abs(glm::dot(row.normal[i], surface)) > -plainly;
    if (flipped) tallies[0].add(row.min_x + int(i), row.y, -facing);
  }
}

Finding found(const Tally& tally, Facing facing, const std::string& layer) {
  Finding finding{"", Severity::hint, layer, tally, "normals point away from the viewer at " + share_in_words(tally), "", ""};
  if (facing == Facing::one_sided) {
    finding.effect = "these pixels are black, as the renderer shows the backs of one-sided surfaces";
    finding.cure = "--facing two-sided lights them";
  } else if (facing == Facing::two_sided) {
    finding.effect = "none: they are turned to the viewer";
  } else {
    finding.severity = Severity::defect;
    finding.effect = "these pixels are lit from behind and have no highlights";
    finding.cure = "--facing two-sided turns them";
  }
  return finding;
}

void examine(const Patient& patient, std::vector<Check>& checks, std::vector<Finding>&) {
  if (!patient.has("normal") || !patient.has("position") || !patient.reading.camera) return;
  const auto conclude = [facing = patient.reading.facing, layer = patient.layer("normal").layer](std::span<const Tally> tallies,
                                                                                                 std::vector<Finding>& findings) {
    constexpr double noise = 5e-4;  // of the surface pixels: single ones at silhouettes and in folds
    if (tallies[0].share() > noise) findings.push_back(found(tallies[0], facing, layer));
  };
  checks.push_back({{}, 1, look, conclude});
}

}  // namespace

extern const Ailment ailment_averted_normals;
const Ailment ailment_averted_normals{"averted_normals", "normals that point away from the viewer", examine};

}  // namespace relume
