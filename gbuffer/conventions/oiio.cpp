// OpenImageIO's tools: write again what others rendered, under the names they had.
#include "gbuffer/common_names.h"

namespace relume {

extern const Convention convention_oiio;
const Convention convention_oiio{
    .name = "oiio",
    .title = "written again by OpenImageIO",
    .source = "OpenImageIO a1045a4, src/openexr.imageio",
    .marks = {{.attribute = "oiio*"}, {.attribute = "Software", .text = "OpenImageIO"}, {.attribute = "Exif:ImageHistory", .text = "oiiotool"}},
    .writes_again = true,
    .assign = take_diffuse,
};

}  // namespace relume
