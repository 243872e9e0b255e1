// The job in a child process, and a parent that only watches: a crash, a standstill or an exit that a library made becomes one line and a documented
// exit code, with nothing left behind (docs/robustness.md).
#pragma once

#include <functional>

namespace relume {

/// Runs `job` in a fork, and again where an OpenCL driver took the process down: first with nothing compiled kept, then without drivers.
/// Its value is the exit code, in the child as in the parent. Must come before any thread and any OpenCL call. Where no process can be forked, the
/// job runs in this one.
int supervised(const std::function<int()>& job);

}  // namespace relume
