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

/// After a driver has taken the process down. Its own compiled programs may have been what it stumbled over (PoCL maps them without a look at their
/// size): a folder of ours is emptied; one that POCL_CACHE_DIR names is somebody else's.
void forget_compiled_programs();

/// From now on no driver is loaded: whoever asks for devices gets an Error{device} that says why.
void distrust_drivers();
bool drivers_are_distrusted();

}  // namespace relume
