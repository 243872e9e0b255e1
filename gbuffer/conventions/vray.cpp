// V-Ray: normals in the frame of each pixel's own viewing ray (research: exr-conventions A.5, measured), depth, and colour apart from light.
#include "gbuffer/role_layers.h"

namespace relume {

extern const Convention convention_vray;
const Convention convention_vray{
    .name = "vray",
    .title = "V-Ray for Maya, 3ds Max, Houdini, Rhino",
    .source = "V-Ray 3.60 file, measured; docs.chaos.com, render elements and their default channel names (pages 27432907, 28417077, 60100479)",
    .marks = {{.attribute = "vray*"},
              {.attribute = "vfb2_layers_json"},
              {.attribute = "cameraTransform"},
              {.layers = {"VRayNormals"}},
              {.layers = {"VRayBumpNormals"}},
              {.layers = {"VRayZDepth"}},
              {.layers = {"VRayDiffuseFilter"}}},
    // Bumps are lit; the elements named for a space come from VRaySamplerInfo and are not in the ray's frame.
    .aliases = {{"normal", {"VRayBumpNormals", "bump_normals", "bumpNormals", "VRayNormals", "normals"}, Says::view_ray},
                {"depth", {"VRayZDepth", "z_depth", "zdepth", "Z"}},
                {"albedo", {"VRayRawDiffuseFilter", "VRayDiffuseFilter", "diffuse_filter", "diffuseFilter", "diffuse"}},
                {"glossiness", {"VRayMtlReflectGlossiness", "mtl_reflect_glossiness", "reflectionGlossiness"}},
                {"metallic", {"VRayMetalness", "VRayMtlMetalness"}},
                {"ior", {"VRayMtlReflectIOR"}},
                {"ids", {"VRayRenderID", "render_id", "VRayObjectID", "object_id", "node_id"}},
                {"diffuse_light", {"VRayLighting", "lighting"}},
                {"diffuse_raw_light", {"VRayRawLighting", "rawLighting", "light_raw", "raw_light"}}},
};

}  // namespace relume
