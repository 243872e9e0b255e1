// Cycles in Gaffer: passes by their names inside Cycles, in lower case, averaged over the pixel.
#include "gbuffer/role_layers.h"

namespace relume {

extern const Convention convention_gaffer;
const Convention convention_gaffer{
    .name = "gaffer",
    .title = "Gaffer, Cycles",
    .source = "gaffer e3b6028, startup; cycles 97dbe6f, src/kernel/film/data_passes.h",
    .marks = {{.attribute = "gaffer*"}, {.layers = {"diffuse_color", "glossy_color"}}},
    .aliases = {{"normal", {"normal"}, Says::world},
                {"position", {"position"}, Says::world},
                {"depth", {"depth"}},
                {"albedo", {"diffuse_color"}},
                {"roughness", {"roughness"}},
                {"ids", {"object_id"}},
                {"uv", {"uv"}}},
    .colour_premultiplied = true,
};

}  // namespace relume
