// Any other renderer: layers by names that people share.
#include "gbuffer/common_names.h"

namespace relume {

extern const Convention convention_generic;
const Convention convention_generic{
    .name = "generic",
    .title = "plain layer names",
    .source = "names collected from many renderers' documents and files",
    .recognised_by = "what no other convention claims",
    .assign = take_diffuse,
};

}  // namespace relume
