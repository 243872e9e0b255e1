// Where compiled programs are kept between runs: a folder of the user's own, closed to everybody else.
#pragma once

#include <filesystem>

namespace relume {

/// $XDG_CACHE_HOME/relume or ~/.cache/relume, mode 0700 and ours; a fresh private folder in the temporary directory where that cannot be
/// (a cached binary is code that will run, so a folder that somebody else could write to is never used). Made once a process.
const std::filesystem::path& cache_folder();

/// Points PoCL's own cache into ours: without a writable HOME its device vanishes, without HOME it would share a predictable folder.
/// Must run before the first OpenCL call.
void prepare_driver_caches();

}  // namespace relume
