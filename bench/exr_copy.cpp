// copy_exr as a program, for bench/shade_against_copy.
//
//   exr_copy IN.exr OUT.exr
#include <cstdio>

#include "bench/plain_copy.h"

int main(int argc, char** argv) {
  if (argc != 3) return std::fprintf(stderr, "usage: exr_copy IN.exr OUT.exr\n"), 2;
  relume::bench::copy_exr(argv[1], argv[2]);
}
