// Runs the fuzzer's target over files, without libFuzzer: what any compiler can build, for ctest and for a look at one crash.
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

void run(const std::filesystem::path& file) {
  std::fprintf(stderr, "%s\n", file.c_str());  // the last name before a crash is its file
  std::ifstream in(file, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

}  // namespace

/// Files, or folders of them.
int main(int argc, char** argv) {
  int count = 0;
  for (int i = 1; i < argc; ++i) {
    if (std::filesystem::is_directory(argv[i])) {
      for (const auto& entry : std::filesystem::directory_iterator(argv[i])) run(entry.path()), ++count;
    } else {
      run(argv[i]), ++count;
    }
  }
  std::printf("%d files, no defect\n", count);
  return count > 0 ? 0 : 2;
}
