// An OpenCL driver for the loader (OCL_ICD_FILENAMES) that takes the process down, or never comes back, when it is loaded: RELUME_FAULT says how.
#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace {

__attribute__((constructor)) void fail() {
  const char* const name = std::getenv("RELUME_FAULT");
  const std::string_view fault = name ? name : "";
  if (fault == "crash") std::abort();
  if (fault == "exit") std::exit(1);  // LLVM's way of saying that a disk is full
  while (fault == "stand") pause();
}

}  // namespace
