// Karma and other renderers under husk: N and P in world space beside _camera ones, numbers that repeat their name (research: exr-conventions A.9).
#include "gbuffer/role_layers.h"

namespace relume {

extern const Convention convention_karma;
const Convention convention_karma{
    .name = "karma",
    .title = "Karma, and USD renderers under husk",
    .source = "FuzzyCactusLogic/AOV_rebuild da67b1e, from Karma renders; sidefx.com, karmastandardrendervars",
    .marks = {{.attribute = "husk*"},
              {.attribute = "Software", .text = "karma"},
              {.attribute = "Software", .text = "husk"},
              {.layers = {"N_camera", "hitdist"}},
              {.layers = {"P_holdouts"}}},
    .aliases = {{"normal", {"N"}, Says::world},
                {"normal", {"N_camera"}, Says::camera},
                {"base_normal", {"Ng"}},
                {"position", {"P"}, Says::world},
                {"position", {"P_camera"}, Says::camera},
                {"depth", {"hitdist"}, Says::distance},
                {"depth", {"depth", "Z", "Pz", "linear_depth"}},
                {"albedo", {"basecolor", "albedo", "albedodiffuse"}},
                {"ids", {"primid", "element"}},
                {"coverage", {"", "C", "beauty"}}},
};

}  // namespace relume
