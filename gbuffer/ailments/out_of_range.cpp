// Material values that no material has: colours below 0 or above 1, roughness and metallic outside 0..1.
#include <algorithm>
#include <cmath>

#include "gbuffer/ailments/ailment.h"
#include "gbuffer/three_digits.h"

namespace relume {
namespace {

constexpr const char* in_unit_range[] = {"albedo",     "base_color", "glossy_albedo",     "roughness", "metallic", "specular_level",
                                         "glossiness", "f0",         "diffuse_roughness", "alpha",     "flatness", "sheen_tint"};

enum Side { below, above, sides };

void look(const Row& row, const std::string& role, std::span<Tally> tallies) {
  constexpr float rounding = 1e-3f;  // half precision, and 8-bit values decoded
  const auto components = row.components(role);
  for (std::size_t i = 0; i < std::size_t(row.width); ++i) {
    if (row.shown[i] == Shown::nothing) continue;
    float lowest = 0, highest = 1;
    for (const float* const c : components) {
      if (!std::isfinite(c[i])) continue;
      lowest = std::min(lowest, c[i]);
      highest = std::max(highest, c[i]);
    }
    for (Tally& tally : tallies) ++tally.judged;
    if (lowest < -rounding) tallies[below].add(row.min_x + int(i), row.y, -lowest);
    if (highest > 1 + rounding) tallies[above].add(row.min_x + int(i), row.y, highest);
  }
}

std::string cure_of(const std::string& role) { return "--map " + role + "=LAYER takes another layer, --set " + role + "=VALUE a constant"; }

/// What Mitsuba stores as a conductor's albedo is what it reflects to the viewer (research: mitsuba-truth); its materials come by object id.
bool reflectance_of_conductors(const Reading& reading, const std::string& role) { return reading.convention == "mitsuba" && role == "albedo"; }

void conclude(std::span<const Tally> t, const std::string& role, const Reading& reading, std::vector<Finding>& findings) {
  const std::string& layer = reading.roles.at(role).layer;
  if (t[below].pixels)
    findings.push_back({"", Severity::defect, layer, t[below],
                        role + " is negative at " + share_in_words(t[below]) + ", down to " + three_digits(-t[below].worst),
                        "these pixels come out too dark, or negative", cure_of(role)});
  if (t[above].pixels == 0) return;
  const bool conductors = reflectance_of_conductors(reading, role);
  findings.push_back({"", conductors ? Severity::hint : Severity::defect, layer, t[above],
                      role + " is above 1 at " + share_in_words(t[above]) + ", up to " + three_digits(t[above].worst) +
                          (conductors ? ": Mitsuba's conductors store no colour there" : ""),
                      "these pixels reflect more than falls on them: too bright", cure_of(role) + "; --materials FILE by object"});
}

void examine(const Patient& patient, std::vector<Check>& checks, std::vector<Finding>&) {
  for (const char* const role : in_unit_range) {
    if (!patient.has(role)) continue;
    checks.push_back({{role},
                      sides,
                      [name = std::string(role)](const Row& row, std::span<Tally> tallies) { look(row, name, tallies); },
                      [name = std::string(role), &reading = patient.reading](std::span<const Tally> t, std::vector<Finding>& f) {
                        conclude(t, name, reading, f);
                      }});
  }
}

}  // namespace

extern const Ailment ailment_out_of_range;
const Ailment ailment_out_of_range{"out_of_range", "material values outside 0..1", examine};

}  // namespace relume
