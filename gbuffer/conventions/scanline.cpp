// 3ds Max's own EXR writer: bare channels NX NY NZ and Z out of its G-buffer.
#include "gbuffer/role_layers.h"

namespace relume {

extern const Convention convention_scanline;
const Convention convention_scanline{
    .name = "scanline",
    .title = "3ds Max G-buffer channels",
    .source = "Autodesk Composite 2011 manual, Import OpenEXR File: NX NY NZ, velX, materialID, objectID (space: the data tell)",
    .marks = {{.layers = {"N", "materialID"}}, {.layers = {"N", "objectID"}}},
    .aliases = {{"normal", {"N"}, Says::camera}, {"depth", {"Z"}}, {"ids", {"objectID"}}},
};

}  // namespace relume
