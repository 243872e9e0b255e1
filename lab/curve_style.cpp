// Colour by BRDF, dashes by lobe; of one lobe alone, dashes where colours begin again.
#include "lab/curve_style.h"

#include "gbuffer/error.h"

namespace relume {
namespace {

constexpr std::size_t colours = figure_colours.size(), most_curves = 2 * colours;  // solid and dashed

}  // namespace

void check_curves(const PlotRequest& request) {
  const bool dashes_taken = request.swap || request.parts.size() > 1;
  const std::size_t most = dashes_taken ? colours : most_curves, count = request.compared.subjects.size();
  const std::string with = request.swap ? " with --swap" : dashes_taken ? " with several --lobes" : "";
  if (request.swap && request.parts.size() > 1)
    throw Error(ErrorKind::input, "--swap, --lobes: one lobe at a time can be told from its exchanged self");
  if (count > most)
    throw Error(ErrorKind::input, "--brdf, --set: " + std::to_string(count) + " curves" + with + " (" + std::to_string(most) + " can be told apart)");
}

std::string curve_style(const PlotRequest& request, std::size_t subject, std::size_t part, bool swapped) {
  const std::string colour = " lt " + std::to_string(subject % colours + 1);
  // Exchanged directions are dashes over a pale band: where both coincide, each is seen.
  if (swapped) return colour + " dt 2 lw 2.5";
  if (request.swap) return std::string(" dt 1 lw 9 lc rgb '#99") + figure_colours[subject % colours] + "'";
  const std::size_t dashes = request.parts.size() > 1 ? part : subject / colours;
  return colour + " dt " + std::to_string(dashes + 1) + " lw 2";
}

}  // namespace relume
