// MoonRay: primitive attributes and material AOVs, components as R G B, X Y Z or U V W.
#include "gbuffer/role_layers.h"

namespace relume {

extern const Convention convention_moonray;
const Convention convention_moonray{
    .name = "moonray",
    .title = "MoonRay",
    .source = "docs.openmoonray.org, RenderOutput",
    .marks = {{.attribute = "moonray*"}, {.attribute = "Software", .text = "moonray"}},
    .aliases = {{"normal", {"normal", "N"}}, {"position", {"position", "P"}}, {"depth", {"depth", "Z"}}, {"albedo", {"albedo", "diffuse_albedo"}}},
};

}  // namespace relume
