// RenderMan: Nn and P in the camera's space, whose z goes into the scene; the world's under names of their own (research: exr-conventions A.6).
#include "gbuffer/role_layers.h"

namespace relume {

extern const Convention convention_renderman;
const Convention convention_renderman{
    .name = "renderman",
    .title = "RenderMan 22 and later",
    .source = "RenderManForBlender 4c13c65, rman_dspychan_definitions.json; rmanwiki.pixar.com 11470996 (space of Nn and P: not verified)",
    .marks = {{.attribute = "Software", .text = "renderman"},
              {.attribute = "Software", .text = "prman"},
              {.attribute = "rman*"},
              {.layers = {"Nworld", "Pworld"}},  // also written __Nworld, __Pworld
              {.layers = {"Nn", "P"}}},
    .aliases = {{"normal", {"Nworld"}, Says::world},
                {"normal", {"Nn"}, Says::camera_forward},
                {"position", {"Pworld"}, Says::world},
                {"position", {"P"}, Says::camera_forward},
                {"depth", {"z", "zfiltered", "depth"}},
                {"albedo", {"albedo", "diffuse_color"}},
                {"uv", {"st"}}},
};

}  // namespace relume
