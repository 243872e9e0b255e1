// A block of rows as OpenEXR's ZIP codec packs it (openexr.com, "OpenEXR File Layout" and ImfZip.cpp): the even bytes before the odd ones, each byte
// as its difference to the one before, deflated. By libdeflate, which takes half of zlib's time either way.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

struct libdeflate_compressor;
struct libdeflate_decompressor;

namespace relume {

/// Unpacks blocks, one after the other.
class ZipUnpacker {
 public:
  ZipUnpacker();

  /// `packed`: as stored in the file; as long as the block itself where packing did not make it smaller. It must outlive take(). Throws
  /// std::runtime_error where it does not unpack to `bytes`.
  void unpack(std::span<const char> packed, std::size_t bytes);

  /// Bytes `first` up to `first` + `count` of the block, both even.
  void take(std::size_t first, std::size_t count, char* to) const;

 private:
  std::unique_ptr<libdeflate_decompressor, void (*)(libdeflate_decompressor*)> inflate_;
  std::vector<unsigned char> halves_;  ///< even bytes, then odd ones
  std::size_t bytes_ = 0;
  const char* plain_ = nullptr;  ///< the block itself, where it is stored unpacked
};

/// Packs blocks, one after the other.
class ZipPacker {
 public:
  ZipPacker();

  /// What a file stores for a block: valid until the next call, and `block` itself where packing does not make it smaller.
  std::span<const char> pack(std::span<const char> block);

 private:
  std::unique_ptr<libdeflate_compressor, void (*)(libdeflate_compressor*)> deflate_;
  std::vector<unsigned char> halves_;
  std::vector<char> packed_;
};

}  // namespace relume
