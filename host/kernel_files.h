// The kernels' text, carried in the program: no file and no -I is needed on a user's machine.
#pragma once

#include <string_view>
#include <vector>

namespace relume {

struct KernelFile {
  std::string_view name;  ///< "kernels/specular/ggx.h", as it is included
  std::string_view text;
};

const std::vector<KernelFile>& kernel_files();

}  // namespace relume
