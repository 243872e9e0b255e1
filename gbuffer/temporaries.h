// The list of temporaries now being written, for a signal handler to remove: a fixed table without locks or allocation,
// in memory that a forked child shares, so that its parent can remove what a crash left.
#pragma once

#include <filesystem>

namespace relume {

/// Notes an absolute path; the slot that holds it, or -1 where the table is full or the path too long.
int note_temporary(const std::filesystem::path& temporary) noexcept;
void forget_temporary(int slot) noexcept;

}  // namespace relume
