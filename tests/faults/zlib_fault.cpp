// Preloaded into the program: a zlib and a libdeflate whose decompressors have the fault that RELUME_FAULT names, as an unpatched decoder of foreign
// bytes may have one. ZIP files go through libdeflate, PXR24 ones through OpenEXR and zlib.
#include <cstdlib>
#include <cstring>
#include <new>
#include <string_view>
#include <vector>

namespace {

void fail() {
  const char* const name = std::getenv("RELUME_FAULT");
  const std::string_view fault = name ? name : "";
  if (fault == "crash") std::abort();
  if (fault == "exit") std::_Exit(1);
  for (volatile bool spin = fault == "spin"; spin;) continue;
  if (fault == "memory") {
    std::vector<char*> taken;  // 64 GB, touched, a little at a time
    for (int i = 0; i < 1024; ++i) std::memset(taken.emplace_back(new char[64 << 20]), 1, 64 << 20);
  }
}

}  // namespace

extern "C" int uncompress(unsigned char*, unsigned long*, const unsigned char*, unsigned long) {
  fail();
  return -3;  // Z_DATA_ERROR
}

extern "C" int libdeflate_zlib_decompress(void*, const void*, unsigned long, void*, unsigned long, unsigned long*) {
  fail();
  return 1;  // LIBDEFLATE_BAD_DATA
}
