// Planes: an anonymous mapping, committed page by page as planes are written.
#include "gbuffer/planes.h"

#include <sys/mman.h>

#include <stdexcept>
#include <string>
#include <utility>

#include "gbuffer/error.h"

namespace relume {

Planes::Planes(std::size_t pixels, int capacity) : pixels_(pixels), stride_((pixels + granule - 1) / granule * granule + shift), capacity_(capacity) {
  const std::size_t bytes = stride_ * std::size_t(capacity) * sizeof(float);
  if (bytes == 0) return;
  void* memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (memory == MAP_FAILED) throw Error(ErrorKind::memory, "no address space for " + std::to_string(bytes) + " bytes of pixel planes");
  base_ = static_cast<float*>(memory);
  constexpr std::size_t huge_page = 2 << 20;
  if (stride_ * sizeof(float) >= huge_page / 4) madvise(memory, bytes, MADV_HUGEPAGE);  // a fault for 512 pages; refused, it costs nothing
}

Planes::~Planes() {
  if (base_) munmap(base_, stride_ * std::size_t(capacity_) * sizeof(float));
}

Planes::Planes(Planes&& other) noexcept
    : base_(std::exchange(other.base_, nullptr)), pixels_(other.pixels_), stride_(other.stride_), capacity_(other.capacity_), count_(other.count_) {}

Planes& Planes::operator=(Planes&& other) noexcept {
  std::swap(base_, other.base_);
  std::swap(pixels_, other.pixels_);
  std::swap(stride_, other.stride_);
  std::swap(capacity_, other.capacity_);
  std::swap(count_, other.count_);
  return *this;
}

int Planes::add(int count) {
  if (count_ + count > capacity_) throw std::logic_error("Planes: more planes than were reserved");
  return std::exchange(count_, count_ + count);
}

}  // namespace relume
