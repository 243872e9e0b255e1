// The id that Cryptomatte gives a name (Psyop, Cryptomatte specification 1.2.0, "ID Generation").
#pragma once

#include <cstdint>
#include <string_view>

namespace relume {

/// MurmurHash3_x86_32 of the name's UTF-8, seed 0, kept clear of the bit patterns of zeros, denormal numbers, infinities and NaN: its bits are stored
/// as a float.
std::uint32_t cryptomatte_id(std::string_view name);

}  // namespace relume
