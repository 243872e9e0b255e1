// material_named: a file, "diffuse+specular", or one name looked up in both lists.
#include "host/brdf_name.h"

#include "gbuffer/error.h"
#include "gbuffer/printable.h"

namespace relume {

Material material_named(const std::string& brdf) {
  Material material;
  if (brdf.ends_with(".binary")) {
    material.diffuse = "none";
    material.specular = "merl";
    material.parameters["table"] = TableValue{shared_merl(brdf)};
    return material;
  }
  if (const std::size_t plus = brdf.find('+'); plus != std::string::npos) {
    material.diffuse = brdf.substr(0, plus);
    material.specular = brdf.substr(plus + 1);
    if (material.diffuse != "none") lobe_named(true, material.diffuse);
    if (material.specular != "none") lobe_named(false, material.specular);
    return material;
  }
  material.diffuse = find_lobe(true, brdf) ? brdf : "none";
  material.specular = find_lobe(false, brdf) ? brdf : "none";
  if (material.diffuse != "none" || material.specular != "none") return material;
  std::string names;
  for (const bool diffuse : {true, false})
    for (const std::string_view name : names_of(diffuse ? diffuse_lobes() : specular_lobes()))
      names += (names.empty() ? "" : ", ") + std::string(name);
  throw Error(ErrorKind::input,
              "no BRDF \"" + printable(brdf) + "\" (has: " + names + "; FILE.binary for a MERL table, DIFFUSE+SPECULAR for a pair)");
}

}  // namespace relume
