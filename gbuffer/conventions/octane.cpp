// Octane: info passes by the names its menus give them, with spaces or without.
#include "gbuffer/role_layers.h"

namespace relume {

extern const Convention convention_octane;
const Convention convention_octane{
    .name = "octane",
    .title = "OctaneRender",
    .source = "docs.otoy.com, Info Channels and Render AOVs (exact channel names and encoding of normals: not verified, the data tell)",
    .marks = {{.attribute = "octane*"},
              {.attribute = "Software", .text = "octane"},
              {.layers = {"Octane*"}},
              {.layers = {"Shading normal", "Diffuse filter"}},
              {.layers = {"Shading normals", "Diffuse filter"}}},
    .aliases = {{"normal", {"Shading normal", "Shading normals", "Smooth normal", "Smooth normals", "Normal"}},
                {"base_normal", {"Geometric normal", "Geometric normals"}},
                {"position", {"Position"}, Says::world},
                {"depth", {"Z-Depth", "Z depth"}},
                {"albedo", {"Diffuse filter", "Diffuse filter (info)", "Diffuse filter info"}},
                {"roughness", {"Roughness", "Roughness (info)"}},
                {"ior", {"IOR", "Index of refraction"}},
                {"ids", {"Object layer ID", "Render layer ID"}}},
};

}  // namespace relume
