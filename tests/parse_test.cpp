// Every kernel file stands alone, as OpenCL C 1.2 and as C++20, at every lane count: a file that lacks an include or uses one language's own word
// fails here.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace relume {
namespace {

const std::filesystem::path kSource = RELUME_SOURCE;
/// Where the build put lobes.h, fresnels.h and lights.h.
const std::filesystem::path kGenerated = RELUME_GENERATED;

constexpr int kLanes[] = {1, 4, 8, 16};

/// Files that a kernel or a lobe may include; the two languages' own files are seen through language.h.
std::vector<std::string> kernel_headers() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kSource / "kernels")) {
    const std::string name = entry.path().lexically_relative(kSource).string();
    if (entry.path().extension() == ".h" && entry.path().filename() != "native.h") names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

struct Outcome {
  int code;
  std::string said;
};

Outcome run(const std::string& command) {
  Outcome outcome{};
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  char line[512];
  while (std::fgets(line, sizeof line, pipe)) outcome.said += line;
  outcome.code = pclose(pipe);
  return outcome;
}

bool runs(const std::string& program) { return run(program + " --version").code == 0; }

/// Warnings, where to look, and the names that a program on a device is built for.
const std::string kOptions =
    " -Wall -Wextra -Werror -Wno-unused-function -fsyntax-only -I" + kSource.string() + " -I" + kGenerated.string() +
    " -DRELUME_DIFFUSE=lambert -DRELUME_SPECULAR=ggx -DRELUME_FRESNEL=schlick -DRELUME_SHADOWING=smith -DRELUME_DISTRIBUTION=ggx ";

/// Makes clang read OpenCL C; the lane count follows.
const std::string kOpenCl =
    "clang -x cl -cl-std=CL1.2 -Xclang -finclude-default-header -Xclang -fdeclare-opencl-builtins -DRELUME_OPENCL" + kOptions + "-DRELUME_LANES=";

/// Source text in a file of this process's own.
std::string temporary(const std::string& name, const std::string& text) {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / ("relume_parse_" + std::to_string(getpid()) + "_" + name);
  std::ofstream(file) << text;
  return file.string();
}

TEST(Parse, EveryFileAloneAsOpenCl) {
  if (!runs("clang")) GTEST_SKIP() << "clang is not here; it is what reads OpenCL C without a device";
  for (const std::string& name : kernel_headers()) {
    const std::string file = temporary("alone.cl", "#include \"" + name + "\"\n");
    for (const int lanes : {1, 16}) {
      const Outcome outcome = run(kOpenCl + std::to_string(lanes) + " " + file);
      EXPECT_EQ(outcome.code, 0) << name << " with " << lanes << " lanes:\n" << outcome.said;
    }
    std::filesystem::remove(file);
  }
}

TEST(Parse, EveryProgramAsOpenClAtEveryLaneCount) {
  if (!runs("clang")) GTEST_SKIP() << "clang is not here; it is what reads OpenCL C without a device";
  for (const auto& entry : std::filesystem::directory_iterator(kSource / "kernels"))
    if (entry.path().extension() == ".cl")
      for (const int lanes : kLanes) {
        const Outcome outcome = run(kOpenCl + std::to_string(lanes) + " " + entry.path().string());
        EXPECT_EQ(outcome.code, 0) << entry.path() << " with " << lanes << " lanes:\n" << outcome.said;
      }
}

const char* const kStandardHeaders = "#include <bit>\n#include <cmath>\n#include <cstddef>\n#include <cstring>\n";
/// What kernels/native.h wants of them: reading the whole of <cmath> for each small file takes most of a minute.
const char* const kStandIns =
    "#define INFINITY __builtin_inff()\nusing size_t = decltype(sizeof 0);\n"
    "namespace std { float sqrt(float); float floor(float); float fabs(float); void* memcpy(void*, const void*, size_t); }\n";

void compile_as_cpp(const std::string& compiler, const char* prologue, const std::string& name, int lanes) {
  const std::string file =
      temporary("alone.cpp", prologue + ("namespace lanes {\n#define RELUME_LANES " + std::to_string(lanes)) + "\n#include \"" + name + "\"\n}\n");
  const Outcome outcome = run(compiler + " -std=c++20 -Wno-psabi -Wno-unknown-warning-option" + kOptions + file);
  std::filesystem::remove(file);
  EXPECT_EQ(outcome.code, 0) << name << " by " << compiler << " with " << lanes << " lanes:\n" << outcome.said;
}

TEST(Parse, EveryFileAloneAsCpp) {
  const std::string compiler = runs("clang++") ? "clang++" : "g++";
  if (!runs(compiler)) GTEST_SKIP() << "neither clang++ nor g++ is here";
  for (const std::string& name : kernel_headers())
    for (const int lanes : {1, 16}) compile_as_cpp(compiler, kStandIns, name, lanes);
}

TEST(Parse, TheProgramAsCppAtEveryLaneCount) {
  for (const std::string compiler : {"g++", "clang++"})
    if (runs(compiler))
      for (const int lanes : kLanes) compile_as_cpp(compiler, kStandardHeaders, "kernels/shade.h", lanes);
}

/// OpenCL C built-ins that round as the driver likes, double literals, and words of one language only.
TEST(Parse, OnlyTheSharedLanguageIsUsed) {
  const std::vector<std::string> forbidden = {"fma(", "mad(",       "pow(",   "powr(",       "exp(",  "exp2(", "log(",  "log2(",
                                              "sin(", "cos(",       "acos(",  "native_",     "half_", "fmin(", "fmax(", "rsqrt(",
                                              "dot(", "normalize(", "double", "static_cast", "std::", "auto "};
  for (const std::string& name : kernel_headers()) {
    if (name == "kernels/language.h") continue;
    std::ifstream in(kSource / name);
    int number = 0;
    for (std::string line; std::getline(in, line);) {
      ++number;
      const std::string code = line.substr(0, line.find("//"));
      if (code.find('"') != std::string::npos) continue;
      for (const std::string& word : forbidden) {
        const size_t at = code.find(word);
        const bool whole = at != std::string::npos && (at == 0 || (!std::isalnum(static_cast<unsigned char>(code[at - 1])) && code[at - 1] != '_'));
        EXPECT_FALSE(whole) << name << ":" << number << ": " << word;
      }
    }
  }
}

}  // namespace
}  // namespace relume
