// What a mistyped name may have meant.
#pragma once

#include <string>
#include <vector>

namespace relume {

/// For the end of a sentence: 'near: "torus", "torso"', else 'has: ' and the first names, else empty.
std::string near_names(const std::string& name, const std::vector<std::string>& names);

}  // namespace relume
