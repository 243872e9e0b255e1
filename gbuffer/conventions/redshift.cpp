// Redshift: world-space N and P, DiffuseFilter apart from light, components spelled out (research: exr-conventions A.7).
#include "gbuffer/role_layers.h"

namespace relume {

extern const Convention convention_redshift;
const Convention convention_redshift{
    .name = "redshift",
    .title = "Redshift",
    .source = "docs.redshift3d.com, Integrated AOVs; third parties' listings of its files",
    .marks = {{.attribute = "rs/*"},
              {.layers = {"DiffuseLighting", "SpecularLighting"}},
              {.layers = {"DiffuseFilter", "DiffuseLightingRaw"}},
              {.layers = {"rsAov_*"}}},
    .aliases = {{"normal", {"BumpNormals", "rsAov_BumpNormals", "N", "Normals", "rsAov_Normals"}, Says::world},
                {"position", {"P", "WorldPosition", "rsAov_WorldPosition"}, Says::world},
                {"depth", {"Z", "Depth", "rsAov_Depth"}},
                {"albedo", {"DiffuseFilter", "rsAov_DiffuseFilter"}},
                {"ids", {"ObjectID", "rsAov_ObjectID"}},
                {"diffuse_light", {"DiffuseLighting"}},
                {"diffuse_raw_light", {"DiffuseLightingRaw", "TotalDiffuseLightingRaw"}}},
};

}  // namespace relume
