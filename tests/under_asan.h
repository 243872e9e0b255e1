// Whether AddressSanitizer watches this program: its shadow memory is terabytes of address space, and faults come to it first.
#pragma once

namespace relume {

#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool under_asan = true;
#elif defined(__has_feature)
inline constexpr bool under_asan = __has_feature(address_sanitizer);
#else
inline constexpr bool under_asan = false;
#endif

}  // namespace relume
