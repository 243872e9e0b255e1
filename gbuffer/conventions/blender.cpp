// Blender's multilayer EXR, versions 2.8 to 5: passes by their fixed names, shader AOVs by names that artists give (research: blender-truth,
// exr-conventions A.1).
#include <set>

#include "gbuffer/find_camera.h"
#include "gbuffer/printable.h"
#include "gbuffer/reading.h"
#include "gbuffer/role_layers.h"

namespace relume {
namespace {

std::string recognise(const ExrFile& file, const std::vector<Layer>&) { return blender_marks(file); }

/// DWA takes a channel named Y for luminance and quantises it by what an eye would miss: X and Z of a position stay exact, Y does not.
void note_lossy_position(const ExrFile& file, Reading& reading) {
  const auto position = reading.roles.find("position");
  if (position == reading.roles.end()) return;
  const Imf::Compression codec = file.parts()[std::size_t(position->second.part)].header.compression();
  if (codec == Imf::DWAA_COMPRESSION || codec == Imf::DWAB_COMPRESSION)
    reading.notes.push_back(
        "warning: DWA compression keeps channels named Y only roughly, so positions and normals are off (ZIP, the default, keeps them)");
}

/// Cycles' own lobes where the passes that they need are there.
void choose_lobes(Reading& reading) {
  if (reading.roles.contains("glossy_albedo") || reading.roles.contains("base_color")) {
    reading.default_diffuse = "cycles";
    reading.default_specular = "cycles_principled";
    return;
  }
  const bool rough = reading.roles.contains("roughness");
  reading.default_diffuse = rough ? "lambert" : "cycles";
  reading.default_specular = rough ? "ggx" : "none";
  reading.notes.push_back(std::string("no GlossCol and no base colour: Cycles' highlights cannot be told; ") +
                          (rough ? "Lambert and GGX with the roughness layer are taken" : "only diffuse light is shaded") +
                          " (--specular NAME and --set say otherwise)");
}

void assign_roles(const ExrFile& file, const std::vector<Layer>& layers, Reading& reading) {
  assign(reading, layers, "position", {"Position"});
  assign(reading, layers, "normal", {"Normal"});
  assign(reading, layers, "depth", {"Depth", "Z"});
  assign(reading, layers, "albedo", {"DiffCol", "Diffuse Color"});
  assign(reading, layers, "glossy_albedo", {"GlossCol", "Glossy Color"});
  assign(reading, layers, "coverage", {"Combined"});
  assign(reading, layers, "ids", {"IndexOB", "Object Index"});
  assign(reading, layers, "uv", {"UV"});
  assign(reading, layers, "roughness", {"Roughness", "rough", "specular roughness"});
  assign(reading, layers, "metallic", {"Metallic", "metalness", "metal"});
  assign(reading, layers, "base_color", {"Base Color", "base colour"});
  assign(reading, layers, "specular_level", {"Specular", "specular level", "specular ior level"});
  assign(reading, layers, "diffuse_roughness", {"Diffuse Roughness"});
  assign(reading, layers, "ior", {"IOR"});
  reading.facing = Facing::as_stored;
  reading.colour_premultiplied = true;
  choose_lobes(reading);
  note_lossy_position(file, reading);
}

/// A view layer that shows a bare floor determines no camera, but all view layers were seen by the same one.
void settle_camera(const ExrFile& file, const ReadingOptions& options, Reading& reading) {
  if (reading.camera) return;
  const auto layers = layers_of(file);
  std::set<std::string> tried{reading.view_layer};
  for (const Layer& layer : layers) {
    if (!tried.insert(layer.view_layer).second) continue;
    Reading other = reading;
    for (const char* role : {"position", "normal", "depth"}) other.roles.erase(role);
    const auto chosen = chosen_layers(layers, layer.view_layer, reading.view);
    assign(other, chosen, "position", {"Position"});
    assign(other, chosen, "normal", {"Normal"});
    assign(other, chosen, "depth", {"Depth"});
    if (!other.roles.contains("position") || !other.roles.contains("normal")) continue;
    if (file.parts()[std::size_t(other.roles.at("position").part)].data_window != reading.data_window) continue;
    find_camera(file, options, other);
    if (!other.camera) continue;
    reading.camera = other.camera;
    reading.camera->source += " of view layer \"" + printable(layer.view_layer) + '"';
    reading.notes.push_back("the camera is taken from view layer \"" + printable(layer.view_layer) + '"');
    return;
  }
}

}  // namespace

extern const Convention convention_blender;
const Convention convention_blender{"blender",
                                    "Blender, multilayer EXR of Cycles or EEVEE",
                                    "Blender 4.5.15 and 5.0.1, measured; blender/blender source, render passes",
                                    recognise,
                                    assign_roles,
                                    nullptr,
                                    settle_camera};

}  // namespace relume
