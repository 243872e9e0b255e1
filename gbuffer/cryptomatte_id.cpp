// MurmurHash3_x86_32 (Austin Appleby, public domain) with Cryptomatte's change to the exponent.
#include "gbuffer/cryptomatte_id.h"

#include <bit>
#include <cstddef>

namespace relume {
namespace {

std::uint32_t scrambled(std::uint32_t block) { return std::rotl(block * 0xcc9e2d51u, 15) * 0x1b873593u; }

/// Up to four bytes, the first the lowest, on any machine.
std::uint32_t block_at(std::string_view bytes, std::size_t begin) {
  std::uint32_t block = 0;
  for (std::size_t i = 0; i < 4 && begin + i < bytes.size(); ++i) block |= std::uint32_t(static_cast<unsigned char>(bytes[begin + i])) << (8 * i);
  return block;
}

std::uint32_t murmur_hash_3(std::string_view bytes) {
  std::uint32_t hash = 0;
  const std::size_t whole = bytes.size() / 4 * 4;
  for (std::size_t i = 0; i < whole; i += 4) hash = std::rotl(hash ^ scrambled(block_at(bytes, i)), 13) * 5 + 0xe6546b64u;
  hash ^= scrambled(block_at(bytes, whole));  // of nothing: 0
  hash ^= std::uint32_t(bytes.size());
  hash = (hash ^ hash >> 16) * 0x85ebca6bu;
  hash = (hash ^ hash >> 13) * 0xc2b2ae35u;
  return hash ^ hash >> 16;
}

}  // namespace

std::uint32_t cryptomatte_id(std::string_view name) {
  const std::uint32_t hash = murmur_hash_3(name), exponent = hash >> 23 & 255;
  return exponent == 0 || exponent == 255 ? hash ^ 1u << 23 : hash;
}

}  // namespace relume
