// Views side by side in one picture, each under its label.
#pragma once

#include <vector>

#include "gbuffer/false_colour.h"

namespace relume {

/// Error{output} where OpenImageIO is not to be had. Without a font that it knows the labels stay blank.
CodedPicture contact_sheet(const std::vector<View>& views);

}  // namespace relume
