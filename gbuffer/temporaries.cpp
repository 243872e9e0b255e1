// Slots go free -> filling -> noted -> free; a handler that interrupts at any point sees only whole paths.
#include "gbuffer/temporaries.h"

#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <climits>
#include <cstring>
#include <new>

#include "gbuffer/whole_file.h"

namespace relume {
namespace {

enum : int { slot_free, slot_filling, slot_noted };

struct Slot {
  std::atomic<int> state{slot_free};
  char path[PATH_MAX] = {};
};
static_assert(std::atomic<int>::is_always_lock_free, "a lock in a signal handler can wait for the thread it interrupted");

using Slots = std::array<Slot, 64>;  // more files than one process writes at a time

/// Made before main(), so that a fork shares it; a process of its own needs no sharing.
Slots& shared_slots() {
  static Slots own;
  void* const memory = mmap(nullptr, sizeof(Slots), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  return memory == MAP_FAILED ? own : *new (memory) Slots;
}

Slots& slots = shared_slots();

}  // namespace

int note_temporary(const std::filesystem::path& temporary) noexcept {
  if (temporary.native().size() >= PATH_MAX) return -1;
  for (std::size_t i = 0; i < slots.size(); ++i) {
    int expected = slot_free;
    if (!slots[i].state.compare_exchange_strong(expected, slot_filling)) continue;
    std::strcpy(slots[i].path, temporary.c_str());
    slots[i].state.store(slot_noted);
    return int(i);
  }
  return -1;
}

void forget_temporary(int slot) noexcept {
  if (slot >= 0) slots[std::size_t(slot)].state.store(slot_free);
}

void remove_temporaries() noexcept {
  for (Slot& slot : slots) {
    if (slot.state.load() != slot_noted) continue;
    unlink(slot.path);
    slot.state.store(slot_free);
  }
}

}  // namespace relume
