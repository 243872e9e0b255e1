// What this process is doing and that it gets on, in memory shared with the parent that watches over it (cli/supervised.h).
#pragma once

#include <atomic>
#include <climits>
#include <cstdint>
#include <string_view>

namespace relume {

/// Code of others, where a crash or a standstill is not our own doing.
enum class Foreign : int {
  none,
  header,  ///< OpenEXR parses a header: nothing that takes long
  pixels,  ///< OpenEXR decodes pixels
  driver,  ///< OpenCL
  mesh     ///< Assimp reads a mesh
};
constexpr int foreign_kinds = 5;

struct Watched {
  std::atomic<std::uint64_t> beats{0};      ///< grows wherever the process gets on
  std::atomic<int> running[foreign_kinds]{};  ///< threads that are in each kind of foreign code
  std::atomic<bool> driver_loaded{false};   ///< its threads may crash us at any time from then on
  std::atomic<bool> input_used{false};      ///< standard input was read, and cannot be read again
  std::atomic<bool> finished{false};        ///< the job has ended and its code stands; what follows is tidying
  std::atomic<int> code{0};                 ///< of the job
  char file[PATH_MAX] = {};                 ///< that `header`, `pixels` and `mesh` are of, printable
  char folder[PATH_MAX] = {};               ///< a temporary folder, to be removed by whoever remains

  /// What runs at present. Beside pixels that are decoded a driver may run: it is the one named, for what it takes down is tried again without it,
  /// and then the pixels are alone.
  Foreign now() const noexcept;
  /// Before a child begins.
  void reset() noexcept;
  /// For the end of the job and for signal handlers.
  void finish(int exit_code) noexcept {
    code = exit_code;
    finished = true;
  }
};
static_assert(std::atomic<std::uint64_t>::is_always_lock_free && std::atomic<int>::is_always_lock_free, "read by another process");

/// One for a process and those that it forks.
Watched& watched();

/// The process got on. Cheap: for each block read or written, each slice shaded.
inline void beat() noexcept { watched().beats.fetch_add(1, std::memory_order_relaxed); }

/// Says for its lifetime that foreign code runs in this thread.
class InForeignCode {
 public:
  explicit InForeignCode(Foreign code, std::string_view file = {});
  ~InForeignCode();
  InForeignCode(const InForeignCode&) = delete;
  InForeignCode& operator=(const InForeignCode&) = delete;

 private:
  Foreign code_;
};

}  // namespace relume
