// What OpenCL drivers find around them: a private folder for compiled programs, and a machine that they can take in.
#pragma once

#include <filesystem>

namespace relume {

/// $XDG_CACHE_HOME/relume or ~/.cache/relume, mode 0700 and ours; a fresh private folder in the temporary directory where that cannot be
/// (a cached binary is code that will run, so a folder that somebody else could write to is never used). Made once a process.
const std::filesystem::path& cache_folder();

/// Points PoCL's own cache into ours: without a writable HOME its device vanishes, without HOME it would share a predictable folder. And tells hwloc,
/// by which PoCL counts cores and memory, what there is where /sys is not to be seen (a bare chroot): PoCL aborts the process otherwise.
/// Must run before the first OpenCL call.
void prepare_driver_environment();

}  // namespace relume
