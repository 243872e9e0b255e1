// The memory of a band of pixels: one reservation, many planes (structure of arrays), so that a CPU device uses them in place (CL_MEM_USE_HOST_PTR)
// and EXR channels decode straight into them.
#pragma once

#include <cstddef>

namespace relume {

class Planes {
 public:
  /// A plane of one float a pixel is rounded up to this many floats: 4096 bytes, and a multiple of every lane count.
  static constexpr std::size_t granule = 1024;
  /// Floats more, five cache lines: a pixel's values a multiple of 4096 bytes apart would compete for the same few places of a cache.
  static constexpr std::size_t shift = 80;

  /// Reserves address space for `capacity` planes; a plane costs memory only once it is written. Throws Error{memory}.
  Planes(std::size_t pixels, int capacity);
  ~Planes();
  Planes(Planes&& other) noexcept;
  Planes& operator=(Planes&& other) noexcept;

  /// The next `count` unused planes, all zero, adjacent in memory; the index of the first.
  int add(int count = 1);

  float* plane(int index) { return base_ + stride_ * std::size_t(index); }
  const float* plane(int index) const { return base_ + stride_ * std::size_t(index); }

  float* data() { return base_; }
  const float* data() const { return base_; }
  std::size_t pixels() const { return pixels_; }
  std::size_t stride() const { return stride_; }  ///< floats from one plane to the next, at least pixels()
  int count() const { return count_; }            ///< planes in use
  std::size_t bytes() const { return stride_ * std::size_t(count_) * sizeof(float); }

 private:
  float* base_ = nullptr;
  std::size_t pixels_ = 0, stride_ = 0;
  int capacity_ = 0, count_ = 0;
};

}  // namespace relume
