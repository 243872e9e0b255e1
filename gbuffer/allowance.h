// A limit on what code that reads foreign bytes may allocate: beyond it new throws and malloc fails, whatever the bytes claim.
#pragma once

#include <cstdint>

namespace relume {

/// For its lifetime, this process may take so many bytes more than it has now. Nested ones do not widen an outer one. By RLIMIT_DATA, which counts
/// what may become private memory: address space alone (RLIMIT_AS) is no measure, drivers and sanitizers reserve terabytes of it.
class Allowance {
 public:
  explicit Allowance(std::int64_t bytes);
  ~Allowance();
  Allowance(const Allowance&) = delete;
  Allowance& operator=(const Allowance&) = delete;
};

}  // namespace relume
