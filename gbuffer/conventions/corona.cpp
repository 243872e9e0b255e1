// Corona: render elements in families, CGeometry_, CShading_, CESSENTIAL_; the denoiser's own in .cxr files.
#include "gbuffer/role_layers.h"

namespace relume {

extern const Convention convention_corona;
const Convention convention_corona{
    .name = "corona",
    .title = "Corona Renderer, EXR and CXR",
    .source = "support.chaos.com 4528507137041, available render elements; oidn 713ec78, training/split_exr.py (space of normals: the data tell)",
    .marks = {{.attribute = "corona*"},
              {.layers = {"CGeometry_*"}},
              {.layers = {"CESSENTIAL_*"}},
              {.layers = {"CShading_*"}},
              {.layers = {"VisibleNormals"}}},
    .aliases = {{"normal", {"CGeometry_NormalsShading", "VisibleNormals"}},
                {"base_normal", {"CGeometry_NormalsGeometry"}},
                {"position", {"CGeometry_WorldPosition"}, Says::world},
                {"depth", {"CGeometry_ZDepth"}},
                {"albedo", {"CShading_Albedo", "CShading_SourceColor", "CShading_RawComponent", "VisibleDiffuse"}},
                {"roughness", {"CShading_Roughness"}},
                {"metallic", {"CShading_Metalness"}},
                {"uv", {"CGeometry_MapCoordinates"}}},
};

}  // namespace relume
