// LuxCore: film channels by their names in capitals; depth is the distance to the hit.
#include "gbuffer/role_layers.h"

namespace relume {

extern const Convention convention_luxcore;
const Convention convention_luxcore{
    .name = "luxcore",
    .title = "LuxCoreRender",
    .source = "LuxCore, slg/film: FilmChannelType and FilmOutputType names; pyluxcore",
    .marks = {{.attribute = "Software", .text = "luxcore"},
              {.layers = {"SHADING_NORMAL", "POSITION"}},
              {.layers = {"AVG_SHADING_NORMAL"}},
              {.layers = {"RGB_IMAGEPIPELINE*"}},
              {.layers = {"RADIANCE_PER_PIXEL_NORMALIZED*"}}},
    .aliases = {{"normal", {"SHADING_NORMAL", "AVG_SHADING_NORMAL"}, Says::world},
                {"base_normal", {"GEOMETRY_NORMAL"}},
                {"position", {"POSITION"}, Says::world},
                {"depth", {"DEPTH"}, Says::distance},
                {"albedo", {"ALBEDO"}},
                {"ids", {"OBJECT_ID"}},
                {"uv", {"UV"}},
                {"coverage", {"ALPHA", "", "RGBA_IMAGEPIPELINE"}}},
};

}  // namespace relume
