// Normals that do not belong to the surface that the positions make: another space, flipped components, or a bumped object's local frame (research:
// mitsuba-truth, bumpmap).
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "gbuffer/ailments/ailment.h"
#include "gbuffer/ailments/neighbourhood.h"
#include "gbuffer/three_digits.h"

namespace relume {
namespace {

using glm::dvec3;

enum Count { off, off_in_other_space, off_and_upright, counts };

/// The normal if it were in camera space where it is read as world, or the other way about.
dvec3 in_other_space(const Row& row, const dvec3& normal) {
  if (!row.reading.camera) return normal;
  const glm::dmat3 world_from_camera(row.reading.camera->world_from_camera);
  return row.reading.normal_space == Space::world ? world_from_camera * normal : glm::transpose(world_from_camera) * normal;
}

void look(const Row& row, std::span<Tally> tallies) {
  if (row.normal.empty() || row.place.empty()) return;
  const Neighbourhood neighbourhood(row);
  const float* const upward = row.stored("normal", 2);
  for (int x = 0; x < row.width; ++x) {
    if (row.shown[std::size_t(x)] != Shown::surface) continue;
    const dvec3 surface = neighbourhood.normal_at(x), &normal = row.normal[std::size_t(x)];
    if (surface == dvec3(0)) continue;
    constexpr double sixty_degrees = 0.5;  // more than bump maps tilt
    const auto misses = [&](const dvec3& n) { return !(std::abs(glm::dot(n, surface)) >= sixty_degrees); };
    for (Tally& tally : tallies) ++tally.judged;
    if (misses(in_other_space(row, normal))) tallies[off_in_other_space].add(row.min_x + x, row.y);
    if (!misses(normal)) continue;
    tallies[off].add(row.min_x + x, row.y, 1 - std::abs(glm::dot(normal, surface)));
    if (upward[x] > 0.8f) tallies[off_and_upright].add(row.min_x + x, row.y);
  }
}

/// One object's normals in its own frame all lie near (0, 0, 1); of normals in another space that is so for a few.
bool local(std::span<const Tally> t) { return double(t[off_and_upright].pixels) > 0.9 * double(t[off].pixels); }

void conclude(std::span<const Tally> t, const Reading& reading, std::vector<Finding>& findings) {
  constexpr double everywhere = 0.2, some = 0.01;  // of the smooth pixels; steep bumps and hair are fewer
  if (t[off].judged == 0 || t[off].share() < some) return;
  const std::string layer = reading.roles.at("normal").layer;
  const std::string what =
      "normals lie more than 60 degrees off the surface that the positions make, at " + share_in_words(t[off]) + " on smooth surfaces";
  const bool elsewhere = reading.camera && t[off].share() > everywhere && t[off_in_other_space].share() < 0.25 * t[off].share();
  const char* const other = reading.normal_space == Space::world ? "camera" : "world";
  if (elsewhere)
    findings.push_back({"", Severity::defect, layer, t[off],
                        what + "; in " + other + " space it would be " + three_digits(100 * t[off_in_other_space].share()) + " %",
                        "lights fall on them from wrong directions", std::string("--normal-space ") + other});
  else if (local(t))
    findings.push_back({"", Severity::defect, layer, t[off], what + ", and nearly all of these are about (0, 0, 1): a bumped object's local frame",
                        "these objects are lit as if they all faced one way",
                        "store the base normal and dp_du too (Mitsuba: geo_normal, dp_du), or --map normal=LAYER with the unbumped one"});
  else
    findings.push_back({"", t[off].share() > everywhere ? Severity::defect : Severity::hint, layer, t[off], what,
                        "lights fall on them from wrong directions, unless they are steep bumps",
                        "--normal-space, --normal-encoding, --convention; --map normal=LAYER"});
}

void examine(const Patient& patient, std::vector<Check>& checks, std::vector<Finding>& findings) {
  const Reading& reading = patient.reading;
  if (!patient.has("normal") || !patient.has("position")) return;
  if (reading.normal_in_tangent_frame) {
    findings.push_back({"",
                        Severity::hint,
                        patient.layer("normal").layer,
                        {},
                        "bumped normals are in the local frame of their surface",
                        "none here: they are turned by the base normal and dp_du; other tools light them wrongly",
                        "--convention overrules"});
    return;
  }
  checks.push_back({{}, counts, look, [&reading](std::span<const Tally> t, std::vector<Finding>& found) { conclude(t, reading, found); }});
}

}  // namespace

extern const Ailment ailment_misplaced_normals;
const Ailment ailment_misplaced_normals{"misplaced_normals", "normals that disagree with the positions", examine};

}  // namespace relume
