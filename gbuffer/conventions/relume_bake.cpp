// relume bake: pixel centres of a mesh, world space, camera in the header, vertices and facets in parts of their own (bake/bake.h).
#include "gbuffer/convention.h"

namespace relume {

extern const Convention convention_relume_bake;
const Convention convention_relume_bake{
    .name = "relume_bake",
    .title = "relume bake",
    .source = "bake/baked_columns.cpp",
    .marks = {{.attribute = "software", .text = "relume bake"}},
    .aliases = {{"position", {"P"}, Says::world},
                {"normal", {"N"}, Says::world},
                {"base_normal", {"Ng"}, Says::world},
                {"depth", {"Z"}},
                {"coverage", {""}},
                {"albedo", {"albedo"}},
                {"roughness", {"roughness"}},
                {"metallic", {"metallic"}},
                {"uv", {"uv"}},
                {"ids", {"id"}},
                {"primitive_ids", {"triangle"}}},
    .takes_common_names = false,
};

}  // namespace relume
