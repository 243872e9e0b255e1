// ZIP blocks: the bytes' order and differences, sixteen at a time where SSE2 is there.
#include "gbuffer/zip_block.h"

#include <libdeflate.h>

#include <cstring>
#include <new>
#include <stdexcept>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace relume {
namespace {

constexpr int middle = 128;  // what stands for a difference of 0
constexpr int level = 4;     // OpenEXR's own; packs half floats 2 % smaller than zlib's does, floats alike

#ifdef __SSE2__

__m128i load(const void* from) { return _mm_loadu_si128(static_cast<const __m128i*>(from)); }
void store(void* to, __m128i bytes) { _mm_storeu_si128(static_cast<__m128i*>(to), bytes); }

/// Each byte the sum of those up to it.
__m128i running_sum(__m128i d) {
  d = _mm_add_epi8(d, _mm_slli_si128(d, 1));
  d = _mm_add_epi8(d, _mm_slli_si128(d, 2));
  d = _mm_add_epi8(d, _mm_slli_si128(d, 4));
  return _mm_add_epi8(d, _mm_slli_si128(d, 8));
}

/// The last byte in every place.
__m128i last_everywhere(__m128i d) {
  const __m128i pairs = _mm_unpackhi_epi8(d, d);
  return _mm_shuffle_epi32(_mm_shufflehi_epi16(pairs, 0xff), 0xff);
}

#endif

/// From differences to values, in place.
void sum_up(unsigned char* bytes, std::size_t count) {
  if (count == 0) return;
  std::size_t i = 1;
#ifdef __SSE2__
  const __m128i middles = _mm_set1_epi8(char(middle));
  __m128i before = _mm_set1_epi8(char(bytes[0]));
  for (; i + 16 <= count; i += 16) {
    const __m128i sums = running_sum(_mm_sub_epi8(load(bytes + i), middles));
    store(bytes + i, _mm_add_epi8(sums, before));
    before = _mm_add_epi8(before, last_everywhere(sums));  // one addition from block to block: the sums do not wait for each other
  }
#endif
  for (; i < count; ++i) bytes[i] = static_cast<unsigned char>(bytes[i - 1] + bytes[i] - middle);
}

/// From values to differences, in place: from the end, where what comes before is still a value.
void take_differences(unsigned char* bytes, std::size_t count) {
  std::size_t i = count;
#ifdef __SSE2__
  const __m128i middles = _mm_set1_epi8(char(middle));
  for (; i >= 17; i -= 16) store(bytes + i - 16, _mm_add_epi8(_mm_sub_epi8(load(bytes + i - 16), load(bytes + i - 17)), middles));
#endif
  for (; i > 1; --i) bytes[i - 1] = static_cast<unsigned char>(bytes[i - 1] - bytes[i - 2] + middle);
}

void interleave(const unsigned char* even, const unsigned char* odd, std::size_t pairs, char* to) {
  std::size_t i = 0;
#ifdef __SSE2__
  for (; i + 16 <= pairs; i += 16) {
    const __m128i e = load(even + i), o = load(odd + i);
    store(to + 2 * i, _mm_unpacklo_epi8(e, o));
    store(to + 2 * i + 16, _mm_unpackhi_epi8(e, o));
  }
#endif
  for (; i < pairs; ++i) {
    to[2 * i] = static_cast<char>(even[i]);
    to[2 * i + 1] = static_cast<char>(odd[i]);
  }
}

void separate(const char* from, std::size_t pairs, unsigned char* even, unsigned char* odd) {
  std::size_t i = 0;
#ifdef __SSE2__
  const __m128i low = _mm_set1_epi16(0xff);
  for (; i + 16 <= pairs; i += 16) {
    const __m128i a = load(from + 2 * i), b = load(from + 2 * i + 16);
    store(even + i, _mm_packus_epi16(_mm_and_si128(a, low), _mm_and_si128(b, low)));
    store(odd + i, _mm_packus_epi16(_mm_srli_epi16(a, 8), _mm_srli_epi16(b, 8)));
  }
#endif
  for (; i < pairs; ++i) {
    even[i] = static_cast<unsigned char>(from[2 * i]);
    odd[i] = static_cast<unsigned char>(from[2 * i + 1]);
  }
}

}  // namespace

ZipUnpacker::ZipUnpacker() : inflate_(libdeflate_alloc_decompressor(), libdeflate_free_decompressor) {
  if (!inflate_) throw std::bad_alloc();
}

void ZipUnpacker::unpack(std::span<const char> packed, std::size_t bytes) {
  bytes_ = bytes;
  plain_ = packed.size() < bytes ? nullptr : packed.data();
  if (plain_) return;
  halves_.resize(bytes);
  // No fewer bytes and no more: rows without bytes of their own would show what was in memory before.
  if (libdeflate_zlib_decompress(inflate_.get(), packed.data(), packed.size(), halves_.data(), bytes, nullptr) != LIBDEFLATE_SUCCESS)
    throw std::runtime_error("Data decompression (zlib) failed.");
  sum_up(halves_.data(), bytes);
}

void ZipUnpacker::take(std::size_t first, std::size_t count, char* to) const {
  if (plain_)
    std::memcpy(to, plain_ + first, count);
  else
    interleave(halves_.data() + first / 2, halves_.data() + bytes_ / 2 + first / 2, count / 2, to);
}

ZipPacker::ZipPacker() : deflate_(libdeflate_alloc_compressor(level), libdeflate_free_compressor) {
  if (!deflate_) throw std::bad_alloc();
}

std::span<const char> ZipPacker::pack(std::span<const char> block) {
  halves_.resize(block.size());
  packed_.resize(block.size());
  separate(block.data(), block.size() / 2, halves_.data(), halves_.data() + block.size() / 2);
  take_differences(halves_.data(), block.size());
  const std::size_t size = libdeflate_zlib_compress(deflate_.get(), halves_.data(), halves_.size(), packed_.data(), packed_.size());
  if (size == 0 || size >= block.size()) return block;
  return {packed_.data(), size};
}

}  // namespace relume
