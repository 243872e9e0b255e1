// Cinema 4D: the Normal and Position passes, whose space and order of components the artist chooses.
#include "gbuffer/role_layers.h"

namespace relume {

extern const Convention convention_cinema4d;
const Convention convention_cinema4d{
    .name = "cinema4d",
    .title = "Cinema 4D, Standard, Physical and ProRender",
    .source = "help.maxon.net, Normal Pass, Position Pass, Multi-Passes (space, encoding and axes: the data tell)",
    .marks = {{.attribute = "Software", .text = "cinema"},
              {.attribute = "Software", .text = "maxon"},
              {.layers = {"World Coordinate", "Shading Normal"}}},
    .aliases = {{"normal", {"Shading Normal", "Normal Pass", "Normal", "Material Normals"}},
                {"base_normal", {"Geometry Normal"}},
                {"position", {"World Coordinate", "Position Pass", "Position"}, Says::world},
                {"depth", {"Depth"}},
                {"albedo", {"Material Color", "Albedo"}},
                {"uv", {"Texture Coordinate", "Material UVW"}}},
};

}  // namespace relume
