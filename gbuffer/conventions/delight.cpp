// 3Delight: names that end in the space they are in (research: exr-conventions A.10, B.3).
#include "gbuffer/role_layers.h"

namespace relume {

extern const Convention convention_delight;
const Convention convention_delight{
    .name = "delight",
    .title = "3Delight",
    .source = "exrs issue 90, a listed header; gaffer e3b6028, startup/gui/outputs.py",
    .marks = {{.attribute = "software", .text = "3delight"}},
    .aliases = {{"normal", {"N.world", "N_world"}, Says::world},
                {"normal", {"N.camera", "N_camera"}, Says::camera},
                {"position", {"P.world", "P_world"}, Says::world},
                {"position", {"P.camera", "P_camera"}, Says::camera},
                {"depth", {"z", "Z", "depth"}},
                {"albedo", {"albedo", "diffuse_color"}}},
};

}  // namespace relume
