// Normals longer than 1, which no mean of unit normals gives.
#include <cmath>

#include "gbuffer/ailments/ailment.h"
#include "gbuffer/three_digits.h"

namespace relume {
namespace {

void look(const Row& row, std::span<Tally> tallies) {
  constexpr float longest = 1.01f;  // half precision and 8-bit encodings stay below
  for (std::size_t i = 0; i < row.length.size(); ++i) {
    if (row.shown[i] == Shown::nothing) continue;
    ++tallies[0].judged;
    if (row.length[i] > longest) tallies[0].add(row.min_x + int(i), row.y, row.length[i]);
  }
}

void examine(const Patient& patient, std::vector<Check>& checks, std::vector<Finding>&) {
  if (!patient.has("normal")) return;
  const std::string layer = patient.layer("normal").layer;
  const auto conclude = [layer](std::span<const Tally> tallies, std::vector<Finding>& findings) {
    if (tallies[0].pixels)
      findings.push_back({"", Severity::hint, layer, tallies[0],
                          "normals are longer than 1 at " + share_in_words(tallies[0]) + ", up to " + three_digits(tallies[0].worst),
                          "none here, they are made unit length; a tool that takes them as they are shades these pixels too bright",
                          "where they are not directions at all: --normal-encoding, --map normal=LAYER"});
  };
  checks.push_back({{}, 1, look, conclude});
}

}  // namespace

extern const Ailment ailment_long_normals;
const Ailment ailment_long_normals{"long_normals", "normals longer than 1", examine};

}  // namespace relume
