// Shared memory is anonymous and mapped at the first use, which must come before the fork to be shared.
#include "gbuffer/watched.h"

#include <sys/mman.h>

#include <cstring>
#include <new>

namespace relume {

Watched& watched() {
  static Watched& shared = []() -> Watched& {
    static Watched own;  // unwatched, then, but running
    void* const memory = mmap(nullptr, sizeof(Watched), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    return memory == MAP_FAILED ? own : *new (memory) Watched;
  }();
  return shared;
}

Foreign Watched::now() const noexcept {
  for (const Foreign code : {Foreign::driver, Foreign::pixels, Foreign::header, Foreign::mesh})
    if (running[int(code)] > 0) return code;
  return Foreign::none;
}

void Watched::reset() noexcept {
  for (std::atomic<int>& threads : running) threads = 0;
  driver_loaded = input_used = finished = false;
  file[0] = folder[0] = '\0';
}

InForeignCode::InForeignCode(Foreign code, std::string_view file) : code_(code) {
  Watched& w = watched();
  if (!file.empty()) {
    const std::size_t length = file.copy(w.file, sizeof w.file - 1);
    w.file[length] = '\0';
  }
  if (code == Foreign::driver) w.driver_loaded = true;
  ++w.running[int(code)];
  beat();
}

InForeignCode::~InForeignCode() {
  --watched().running[int(code_)];
  beat();
}

}  // namespace relume
