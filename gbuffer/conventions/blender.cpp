// Blender's multilayer EXR, versions 2.8 to 5: passes by their fixed names, shader AOVs by names that artists give (research: blender-truth,
// exr-conventions A.1).
#include <set>

#include "gbuffer/find_camera.h"
#include "gbuffer/printable.h"
#include "gbuffer/reading.h"
#include "gbuffer/role_layers.h"
#include "gbuffer/samples.h"

namespace relume {
namespace {

/// Passes have fixed names; shader AOVs (from roughness on) have those that artists give them.
const std::vector<Alias> aliases{{"position", {"Position"}, Says::world},
                                 {"normal", {"Normal"}, Says::world},
                                 {"normal", {"Denoising Normal"}, Says::camera},
                                 {"depth", {"Depth", "Z"}},
                                 {"albedo", {"DiffCol", "Diffuse Color"}},
                                 {"glossy_albedo", {"GlossCol", "Glossy Color"}},
                                 {"coverage", {"Combined"}},
                                 {"ids", {"IndexOB", "Object Index"}},
                                 {"uv", {"UV"}},
                                 {"roughness", {"Roughness", "rough", "specular roughness"}},
                                 {"metallic", {"Metallic", "metalness", "metal"}},
                                 {"base_color", {"Base Color", "base colour"}},
                                 {"specular_level", {"Specular", "specular level", "specular ior level"}},
                                 {"diffuse_roughness", {"Diffuse Roughness"}},
                                 {"ior", {"IOR"}}};

std::string recognise(const ExrFile& file, const std::vector<Layer>&) { return blender_marks(file); }

/// Cycles' own lobes where the passes that they need are there.
void choose_lobes(Reading& reading) {
  if (reading.roles.contains("glossy_albedo") || reading.roles.contains("base_color")) {
    reading.default_diffuse = "cycles";
    reading.default_specular = "cycles_principled";
    return;
  }
  const bool rough = reading.roles.contains("roughness");
  reading.default_diffuse = rough ? "gltf" : "cycles";
  reading.default_specular = rough ? "ggx" : "none";
  reading.notes.push_back(std::string("no GlossCol and no base colour: Cycles' highlights cannot be told; ") +
                          (rough ? "glTF's surface with the roughness layer is taken" : "only diffuse light is shaded") +
                          " (--specular NAME and --set say otherwise)");
}

/// A view layer that shows a bare floor determines no camera, but all view layers were seen by the same one.
void settle_camera(Samples& samples, const ReadingOptions& options, Reading& reading) {
  if (reading.camera && !reading.camera->assumed_lens) return;
  const auto layers = layers_of(samples.file());
  std::set<std::string> tried{reading.view_layer};
  for (const Layer& layer : layers) {
    if (!tried.insert(layer.view_layer).second) continue;
    Reading other = reading;
    other.camera.reset();
    for (const char* role : {"position", "normal", "depth"}) other.roles.erase(role);
    const auto chosen = chosen_layers(layers, layer.view_layer, reading.view);
    const auto named = named_layers(chosen, [](const Layer& l) { return l.name; });
    for (const char* role : {"position", "normal", "depth"})
      for (const Alias& alias : aliases)
        if (alias.role == std::string(role)) assign(other, named, alias);
    if (!other.roles.contains("position") || !other.roles.contains("normal")) continue;
    if (samples.file().parts()[std::size_t(other.roles.at("position").part)].data_window != reading.data_window) continue;
    find_camera(samples, options, other);
    if (!other.camera || other.camera->assumed_lens) continue;
    reading.camera = other.camera;
    reading.camera->source += " of view layer \"" + printable(layer.view_layer) + '"';
    reading.notes.push_back("the camera is taken from view layer \"" + printable(layer.view_layer) + '"');
    return;
  }
}

}  // namespace

extern const Convention convention_blender;
const Convention convention_blender{
    .name = "blender",
    .title = "Blender 2.7 to 5, multilayer EXR of Cycles or EEVEE",
    .source = "Blender 4.5.15 and 5.0.1, measured; blender/blender source, render passes",
    .marks = {{.attribute = "BlenderMultiChannel"}, {.attribute = "Software", .text = "blender"}},
    .aliases = aliases,
    .colour_premultiplied = true,
    .recognise = recognise,
    .recognised_by = "a layer Combined, DiffCol, GlossCol, Diffuse Color or Glossy Color of some view layer",
    .choose_lobes = choose_lobes,
    .settle = settle_camera,
};

}  // namespace relume
