// The yardstick of `relume shade`: every channel of an EXR read and written again with OpenEXR alone, on all cores.
#pragma once

#include <filesystem>

namespace relume::bench {

void copy_exr(const std::filesystem::path& in, const std::filesystem::path& out);

}  // namespace relume::bench
