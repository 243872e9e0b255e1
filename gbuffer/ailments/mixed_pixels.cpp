// Filtered layers: pixels whose values are means over several surfaces.
#include "gbuffer/ailments/ailment.h"

namespace relume {
namespace {

void look(const Row& row, std::span<Tally> tallies) {
  for (std::size_t i = 0; i < row.shown.size(); ++i) {
    if (row.shown[i] == Shown::nothing) continue;
    ++tallies[0].judged;
    if (row.shown[i] == Shown::mixture) tallies[0].add(row.min_x + int(i), row.y, 1 - row.length[i]);
  }
}

void conclude(std::span<const Tally> t, const Reading& reading, std::vector<Finding>& findings) {
  const Tally& tally = t[0];
  if (tally.pixels == 0) return;
  constexpr double edges = 0.5;  // more than half a frame of edges is something else
  const std::string premultiplied = reading.position_premultiplied ? "; layers are divided by coverage" : "";
  if (tally.share() < edges)
    findings.push_back(
        {"", Severity::hint, "", tally, "anti-aliased layers: " + share_in_words(tally) + " mix surfaces" + premultiplied,
         "relume shade takes such pixels apart by the surfaces around them; what it cannot explain is shaded as the mean, which is only nearly right",
         "render data with a closest filter or one sample a pixel, and anti-alias by Cryptomatte or at double size"});
  else
    findings.push_back({"", Severity::hint, reading.roles.contains("normal") ? reading.roles.at("normal").layer : "", tally,
                        "normals are shorter than 1, or coverage is partial, at " + share_in_words(tally) + premultiplied,
                        "none from the length, normals are made unit length; means over rough or moving surfaces look smoother than they are", ""});
}

void examine(const Patient& patient, std::vector<Check>& checks, std::vector<Finding>&) {
  if (!patient.has("normal")) return;
  checks.push_back({{}, 1, look, [&reading = patient.reading](std::span<const Tally> t, std::vector<Finding>& f) { conclude(t, reading, f); }});
}

}  // namespace

extern const Ailment ailment_mixed_pixels;
const Ailment ailment_mixed_pixels{"mixed_pixels", "pixels that mix surfaces", examine};

}  // namespace relume
