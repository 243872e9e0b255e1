// Nuke: writes again what others rendered, with layers as its users named them and components spelled out.
#include "gbuffer/common_names.h"

namespace relume {

extern const Convention convention_nuke;
const Convention convention_nuke{
    .name = "nuke",
    .title = "written again by Nuke",
    .source = "OpenImageIO testsuite/cryptomatte, files that Nuke wrote; Foundry, Write node's metadata",
    .marks = {{.attribute = "nuke/*"}},
    .writes_again = true,
    .assign = take_diffuse,
};

}  // namespace relume
