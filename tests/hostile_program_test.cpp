// The corpus of bad files through the program's commands: every run ends in a result or one line that begins with the file, soon, in little memory,
// with nothing left behind. Prints how many ended how.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <deque>
#include <iostream>
#include <map>

#include "tests/make_gbuffer.h"
#include "tests/run_program.h"
#include "tests/under_asan.h"

namespace relume {
namespace {

namespace fs = std::filesystem;

constexpr double most_seconds = 5;     // of processor time: a busy machine is no hang
constexpr long most_memory = 1 << 20;  // KiB resident
constexpr bool measured = !under_asan;

struct Ended {
  int status = 0;
  double seconds = 0;
  long kibibytes = 0;
  std::string out, err;
  int code() const { return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status); }
};

/// As run_program, but without a shell, whose own needs would count, and without waiting at once.
class Child {
 public:
  explicit Child(std::vector<std::string> arguments) : command(arguments.front()) {
    arguments.insert(arguments.begin(), RELUME_PROGRAM);
    child_ = fork();
    if (child_ != 0) return;
    std::vector<char*> words;
    for (std::string& word : arguments) words.push_back(word.data());
    words.push_back(nullptr);
    dup2(open((scratch_ / "out").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
    dup2(open((scratch_ / "err").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
    execv(RELUME_PROGRAM, words.data());
    _exit(127);
  }

  Ended ended() const {
    Ended run;
    rusage usage{};
    wait4(child_, &run.status, 0, &usage);
    run.seconds = double(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) + 1e-6 * double(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
    run.kibibytes = usage.ru_maxrss;
    run.out = text_of_file(scratch_ / "out");
    run.err = text_of_file(scratch_ / "err");
    return run;
  }

  const std::string command;

 private:
  TemporaryFolder scratch_;
  pid_t child_ = -1;
};

bool raw(const std::string& text) {
  return std::any_of(text.begin(), text.end(), [](unsigned char c) { return (c < 0x20 && c != '\n') || c == 0x7f; });
}

/// What is wrong with an ending; empty where nothing is.
std::string fault(const Ended& run, const fs::path& file) {
  const int code = run.code();
  if (code != 0 && code != 1 && code != 2 && code != 4) return "ended with " + std::to_string(code);
  const bool one_line = std::count(run.err.begin(), run.err.end(), '\n') == 1 && run.err.starts_with("relume: " + file.string() + ": ");
  if (code >= 2 && !one_line) return "is not explained in one line: " + run.err;
  if (raw(run.out) || raw(run.err)) return "prints control characters";
  if (measured && run.seconds > most_seconds) return "took " + std::to_string(run.seconds) + " s";
  if (measured && run.kibibytes > most_memory) return "took " + std::to_string(run.kibibytes) + " KiB";
  return {};
}

TEST(HostileProgram, EveryCommandEndsWell) {
  fs::path root = fs::path(RELUME_CORPUS) / "bad-exr";
  if (!fs::exists(root)) root = fs::path(RELUME_SOURCE) / "tests/data/hostile";
  const TemporaryFolder inputs, outputs;
  write_gbuffer(inputs / "good.exr", {});
  const std::string rig = (inputs / "rig.json").string(), good = (inputs / "good.exr").string(), out = (outputs / "out.exr").string();
  std::ofstream(rig) << R"({"relume": 1, "lights": [{"type": "point", "position": [2, 3, 4], "intensity": [40, 38, 35]}], "camera": )"
                     << scene_camera_json << "}";
  std::map<std::string, std::map<std::string, std::map<int, int>>> endings;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    const std::string file = entry.path().string();
    if (entry.path().extension() != ".exr") continue;
    std::deque<Child> children;
    for (const std::vector<std::string>& arguments : {std::vector<std::string>{"inspect", file},
                                                      {"inspect", "--json", file},
                                                      {"doctor", file, "--lights", rig},
                                                      {"compare", file, good},
                                                      {"inspect", good, "--camera", file},
                                                      {"shade", file, "-l", rig, "-o", out, "--device", "twin"}})
      children.emplace_back(arguments);
    for (const Child& child : children) {
      const Ended ended = child.ended();
      EXPECT_EQ(fault(ended, entry.path()), "") << child.command << " " << file;
      ++endings[child.command][entry.path().parent_path().filename()][ended.code()];
      if (child.command == "shade" && ended.code() == 0) fs::remove(out);
    }
    EXPECT_TRUE(fs::is_empty(outputs.path())) << file << " leaves something";
  }
  for (const auto& [command, folders] : endings)
    for (const auto& [folder, codes] : folders) {
      std::cout << command << " " << folder << ":";
      for (const auto& [code, count] : codes) std::cout << " exit " << code << ": " << count;
      std::cout << "\n";
    }
}

}  // namespace
}  // namespace relume
