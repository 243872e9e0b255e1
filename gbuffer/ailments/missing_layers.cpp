// Materials that the file does not tell.
#include <algorithm>
#include <array>

#include "gbuffer/ailments/ailment.h"

namespace relume {
namespace {

void examine(const Patient& patient, std::vector<Check>&, std::vector<Finding>& findings) {
  if (!patient.understood) return;
  const auto any = [&](auto... roles) { return (patient.has(roles) || ...); };
  if (!any("albedo", "base_color", "glossy_albedo"))
    findings.push_back({"",
                        Severity::hint,
                        "",
                        {},
                        "no albedo layer",
                        "every surface has the same colour",
                        "--set albedo=R,G,B; --map albedo=LAYER; --materials FILE"});
  if (!any("roughness", "alpha", "glossiness", "exponent"))
    findings.push_back({"",
                        Severity::hint,
                        "",
                        {},
                        "no roughness layer",
                        patient.reading.default_specular == "none" ? "only diffuse light is shaded" : "highlights have the default width everywhere",
                        "--set roughness=0.4; --map roughness=LAYER; --materials FILE"});
}

}  // namespace

extern const Ailment ailment_missing_layers;
const Ailment ailment_missing_layers{"missing_layers", "materials that the file does not tell", examine};

}  // namespace relume
