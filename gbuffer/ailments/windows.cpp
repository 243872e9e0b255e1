// Data windows that differ between layers, or lie beside the picture.
#include <algorithm>

#include "gbuffer/ailments/ailment.h"
#include "gbuffer/mesh_parts.h"

namespace relume {
namespace {

std::string in_words(const Window& w) {
  return std::to_string(w.width()) + " x " + std::to_string(w.height()) + " at " + std::to_string(w.min_x) + ", " + std::to_string(w.min_y);
}

Window both(const Window& a, const Window& b) {
  return {std::max(a.min_x, b.min_x), std::max(a.min_y, b.min_y), std::min(a.max_x, b.max_x), std::min(a.max_y, b.max_y)};
}

Tally lost_pixels(const Window& whole, const Window& kept) {
  Tally tally;
  tally.pixels = whole.pixels() - kept.pixels();
  tally.judged = whole.pixels();
  tally.box = whole;
  tally.x = whole.min_x, tally.y = whole.min_y;
  if (kept.min_x == whole.min_x && kept.min_y == whole.min_y) tally.x = whole.max_x - 1, tally.y = whole.max_y - 1;
  return tally;
}

/// Only pixels that every layer has can be relit.
void compare_layers(const Patient& patient, std::vector<Finding>& findings) {
  const Window& used = patient.reading.data_window;
  const RoleLayer* largest = nullptr;
  Window whole = used;
  for (const auto& [role, layer] : patient.reading.roles)
    if (const Window& own = patient.part_of(role).data_window; own.pixels() > whole.pixels()) whole = own, largest = &layer;
  if (largest)
    findings.push_back({"", Severity::defect, largest->layer, lost_pixels(whole, used),
                        "layers have unequal data windows: this one is " + in_words(whole) + ", all have " + in_words(used) + " in common",
                        "the picture is black outside what they have in common", "--map ROLE=LAYER takes a layer of the full window"});
}

void compare_parts(const Patient& patient, std::vector<Finding>& findings) {
  const auto& parts = patient.file.parts();
  const auto other = std::find_if(parts.begin(), parts.end(), [&](const Part& p) {
    return !(p.data_window == parts.front().data_window) && !(patient.reading.convention == "relume_bake" && is_mesh_part(p));
  });
  if (other == parts.end() || !patient.understood) return;
  findings.push_back({"",
                      Severity::hint,
                      "",
                      {},
                      "parts have unequal data windows: part 0 is " + in_words(parts.front().data_window) + ", part " + std::to_string(other->index) +
                          " is " + in_words(other->data_window),
                      "none, where layers of one window are read",
                      "--part N reads one part alone"});
}

void compare_with_display(const Patient& patient, std::vector<Finding>& findings) {
  const Window &data = patient.reading.data_window, &display = patient.reading.display_window;
  if (data.empty() || display.empty()) return;
  const Window seen = both(data, display);
  if (seen.empty())
    findings.push_back({"", Severity::defect, "", lost_pixels(data, {}),
                        "the data window, " + in_words(data) + ", lies outside the display window, " + in_words(display),
                        "viewers show nothing of the picture", "set the windows right with oiiotool --origin or --fullsize"});
  else if (!(seen == data))
    findings.push_back({"", Severity::hint, "", lost_pixels(data, seen),
                        "the data window, " + in_words(data) + ", reaches beyond the display window, " + in_words(display) + ": overscan",
                        "none: all of it is relit", "--crop X0,Y0,X1,Y1 leaves it out"});
}

void examine(const Patient& patient, std::vector<Check>&, std::vector<Finding>& findings) {
  compare_layers(patient, findings);
  compare_parts(patient, findings);
  compare_with_display(patient, findings);
}

}  // namespace

extern const Ailment ailment_windows;
const Ailment ailment_windows{"windows", "data windows that do not fit together", examine};

}  // namespace relume
