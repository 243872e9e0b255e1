// Mantra: P and N as its shaders see them, in camera space, and Pz.
#include "gbuffer/role_layers.h"

namespace relume {

extern const Convention convention_mantra;
const Convention convention_mantra{
    .name = "mantra",
    .title = "Houdini Mantra",
    .source = "sidefx.com, Mantra: Rendering extra image planes (P and N of VEX's current space, which is the camera's)",
    .marks = {{.attribute = "Software", .text = "mantra"},
              {.attribute = "Software", .text = "houdini"},
              {.layers = {"Pz", "P"}},
              {.layers = {"Pz", "N"}}},
    .aliases = {{"normal", {"N_world", "Nworld"}, Says::world},
                {"normal", {"N"}, Says::camera},
                {"position", {"P_world", "Pworld"}, Says::world},
                {"position", {"P"}, Says::camera},
                {"depth", {"Pz"}},
                {"albedo", {"basecolor", "diffuse_color_noshading", "diffuse_unlighted"}},
                {"roughness", {"rough"}},
                {"coverage", {"", "C"}}},
};

}  // namespace relume
