// Runs the program as a user would: arguments in, exit code and both outputs back.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace relume {

struct ProgramRun {
  int code = -1;    ///< exit code, or -signal
  std::string out;  ///< stdout
  std::string err;  ///< stderr
};

/// A folder of the test's own, removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "relume-test-XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline std::string shell_quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

inline std::string text_of_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// `before`: what the shell reads in front of the program: "NAME=value", "ulimit -f 8;".
inline ProgramRun run_program(const std::vector<std::string>& arguments, const std::string& input = {}, const std::string& before = {}) {
  const TemporaryFolder folder;
  std::ofstream(folder / "in") << input;
  std::string command = before + " " + shell_quoted(RELUME_PROGRAM);
  for (const std::string& argument : arguments) command += " " + shell_quoted(argument);
  command += " <" + shell_quoted((folder / "in").string()) + " >" + shell_quoted((folder / "out").string()) + " 2>" +
             shell_quoted((folder / "err").string());
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), text_of_file(folder / "out"), text_of_file(folder / "err")};
}

}  // namespace relume
