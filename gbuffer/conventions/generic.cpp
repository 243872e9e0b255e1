// Any other renderer: layers by the names that are common to many (research: exr-conventions 0.3), spaces by the names' own hints.
#include "gbuffer/reading.h"
#include "gbuffer/role_layers.h"

namespace relume {
namespace {

std::string recognise(const ExrFile&, const std::vector<Layer>&) { return "no renderer's marks: common names"; }

/// World space where there is a choice, then names that do not say, then camera space.
void assign_geometry(const std::vector<Layer>& layers, Reading& reading) {
  assign(reading, layers, "normal",
         {"Nworld", "N.world", "WorldNormal", "sh_normal", "shading normal", "Ns", "N", "Normal", "Normals", "nn", "VisibleNormals", "OptixNormals"});
  if (!reading.roles.contains("normal")) {
    assign(reading, layers, "normal", {"N_camera", "N.camera", "Denoising Normal"});
    if (reading.roles.contains("normal")) reading.normal_space = Space::camera;
  }
  assign(reading, layers, "position", {"Pworld", "P.world", "WorldPosition", "P", "Position", "pos", "worldpos", "point position"});
  if (!reading.roles.contains("position")) {
    assign(reading, layers, "position", {"P_camera", "P.camera"});
    if (reading.roles.contains("position")) reading.position_space = Space::camera;
  }
}

void assign_roles(const ExrFile&, const std::vector<Layer>& layers, Reading& reading) {
  assign_geometry(layers, reading);
  assign(reading, layers, "depth", {"Z", "depth", "zfiltered", "WorldDepth", "hitdist"});
  assign(reading, layers, "albedo",
         {"albedo", "base color", "diffuse_albedo", "DiffCol", "Diffuse Color", "DiffuseFilter", "diffuse filter", "albedodiffuse", "VisibleDiffuse",
          "Denoising Albedo"});
  assign(reading, layers, "roughness", {"roughness", "rough", "specular_roughness"});
  assign(reading, layers, "metallic", {"metallic", "metalness", "metal"});
  assign(reading, layers, "f0", {"f0", "specular_f0"});
  assign(reading, layers, "coverage", {"", "RGBA", "beauty", "Combined"});
  assign(reading, layers, "ids", {"id", "ids", "object_id", "IndexOB", "Object Index", "shape_index", "element"});
  assign(reading, layers, "uv", {"uv", "st", "UVs"});
  reading.facing = Facing::as_stored;
}

}  // namespace

extern const Convention convention_generic;
const Convention convention_generic{
    "generic", "plain layer names", "names collected from many renderers' documents and files", recognise, assign_roles, nullptr, nullptr};

}  // namespace relume
