// Iray and mental ray: normals in camera space, depth along the camera's axis.
#include "gbuffer/role_layers.h"

namespace relume {

extern const Convention convention_iray;
const Convention convention_iray{
    .name = "iray",
    .title = "Iray, mental ray",
    .source = "a listed header of Iray for Maya (affaritaliani.it 2049365); help.solidworks.com 2021, render layers of Visualize",
    .marks = {{.attribute = "IFM_*"}, {.attribute = "comments", .text = "iray"}, {.attribute = "comments", .text = "mental ray"}},
    .aliases = {{"normal", {"normal"}, Says::camera}, {"depth", {"depth", "Z"}}, {"albedo", {"albedo"}}, {"ids", {"object_id"}}},
};

}  // namespace relume
