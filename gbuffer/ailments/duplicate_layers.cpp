// Layers of one name, of which one is read.
#include <map>

#include "gbuffer/ailments/ailment.h"
#include "gbuffer/mesh_parts.h"
#include "gbuffer/printable.h"
#include "gbuffer/role_layers.h"

namespace relume {
namespace {

/// A mesh's vertices beside the pixels that show them are no second layer.
bool is_list(const Patient& patient, int part) {
  return patient.reading.convention == "relume_bake" && part != patient.reading.part && is_mesh_part(patient.file.parts()[std::size_t(part)]);
}

void examine(const Patient& patient, std::vector<Check>&, std::vector<Finding>& findings) {
  std::map<std::string, std::vector<Layer>> by_name;
  for (const Layer& layer : chosen_layers(layers_of(patient.file), patient.reading.view_layer, patient.reading.view))
    if (!layer.name.empty() && !is_list(patient, layer.part)) by_name[normalised(layer.name)].push_back(layer);
  for (const auto& [role, read] : patient.reading.roles) {
    for (const auto& [name, layers] : by_name) {
      std::string spellings;
      bool concerns = false;
      for (const Layer& layer : layers) {
        concerns |= layer.part == read.part && display_name(layer, false) == read.layer;
        spellings += (spellings.empty() ? "" : ", ") + ('"' + printable(display_name(layer, false)) + "\" in part " + std::to_string(layer.part));
      }
      if (concerns && layers.size() > 1)
        findings.push_back({"",
                            Severity::hint,
                            read.layer,
                            {},
                            std::to_string(layers.size()) + " layers have one name: " + spellings,
                            "the first is read as " + role,
                            "--part N, --map " + role + "=LAYER"});
    }
  }
}

}  // namespace

extern const Ailment ailment_duplicate_layers;
const Ailment ailment_duplicate_layers{"duplicate_layers", "layers of one name", examine};

}  // namespace relume
