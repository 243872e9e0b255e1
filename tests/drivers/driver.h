// The OpenCL drivers that the kernels must run on: how a child process gets each one alone, and how far its results may stray from the C++ twin's.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/run_program.h"

namespace relume {

struct Driver {
  std::string name;
  std::filesystem::path icd;          ///< what OCL_ICD_VENDORS names; there is no driver where it is missing
  std::vector<std::string> settings;  ///< VARIABLE=value for the child
  std::vector<std::string> command;   ///< stands before the child's own words
  int pixels;                         ///< of the made-up band
  bool one_lane_too;                  ///< also with one pixel a work-item, where its own are more
  /// The largest relative difference from the twin, with ordinary parameters and with all that the lists allow.
  double ordinary, whole;
  const char* precision = "exact";
};

/// The same driver with --precision relaxed. It strays as devices may that do not round divide and square root correctly.
inline Driver relaxed(Driver driver) {
  driver.name += ", relaxed";
  driver.precision = "relaxed";
  driver.one_lane_too = false;
  driver.ordinary = 1e-4;
  driver.whole = 5e-3;
  return driver;
}

inline std::filesystem::path drivers_folder() { return std::filesystem::path(RELUME_SOURCE) / "build" / "drivers"; }

/// The loader reads its environment once a process: so every driver has a child of its own, and no driver sees another's libraries.
inline Driver pocl() {
  const std::filesystem::path icd = "/etc/OpenCL/vendors/pocl.icd";
  // It rounds divide and square root correctly when asked to, and the kernels use exact operations only.
  return {"PoCL", icd, {"OCL_ICD_VENDORS=" + icd.string()}, {}, 2003, true, 0, 0};
}

inline Driver intel() {
  const std::filesystem::path folder = drivers_folder() / "intel";
  std::string libraries = text_of_file(folder / "library_path");
  if (!libraries.empty() && libraries.back() == '\n') libraries.pop_back();
  // It does not promise correct rounding, but divides with the processor's own instruction, which rounds correctly.
  return {"Intel", folder / "intel.icd", {"OCL_ICD_VENDORS=" + folder.string(), "LD_LIBRARY_PATH=" + libraries}, {}, 2003, true, 0, 0};
}

inline Driver rusticl() {
  const std::filesystem::path icd = "/etc/OpenCL/vendors/rusticl.icd";
  // As Intel's. Its compiler takes a minute and more for a kernel over explicit lanes; its own width is one.
  return {"rusticl", icd, {"OCL_ICD_VENDORS=" + icd.string(), "RUSTICL_ENABLE=llvmpipe"}, {}, 2003, false, 0, 0};
}

/// The simulator checks every access and race; `log` gets its reports, `cache` is a cache folder of its own, for the option below is not in a
/// cached program's key.
inline Driver oclgrind(const std::filesystem::path& log, const std::filesystem::path& cache, int pixels) {
  // -cl-opt-disable: clang's inlining leaves llvm.experimental.noalias.scope.decl behind, which Oclgrind 21.10 does not know.
  return {"Oclgrind",
          "/usr/bin/oclgrind",
          {"XDG_CACHE_HOME=" + cache.string()},
          {"oclgrind", "--data-races", "--check-api", "--build-options", "-cl-opt-disable", "--log", log.string()},
          pixels,
          false,
          0,
          0};
}

/// Runs `words` with the driver's environment.
inline ProgramRun run_under(const Driver& driver, const std::vector<std::string>& words) {
  const TemporaryFolder folder;
  std::string command = "exec env";
  for (const auto* list : {&driver.settings, &driver.command, &words})
    for (const std::string& word : *list) command += " " + shell_quoted(word);
  command += " >" + shell_quoted((folder / "out").string()) + " 2>" + shell_quoted((folder / "err").string());
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), text_of_file(folder / "out"), text_of_file(folder / "err")};
}

}  // namespace relume
