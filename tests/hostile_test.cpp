// Damaged, disguised and oversized files: each is opened and read in a process of its own, which must end by success or by a refusal in one line.
// This process never touches ExrFile itself: OpenEXR's threads would not survive the fork.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <random>
#include <sstream>

#include "gbuffer/error.h"
#include "gbuffer/exr_file.h"
#include "tests/under_asan.h"

namespace {

namespace fs = std::filesystem;
using relume::Destination;
using relume::Error;
using relume::ErrorKind;
using relume::ExrFile;
using relume::SampleType;
using relume::Window;

constexpr bool memory_is_measured = !relume::under_asan;
constexpr rlim_t seconds = 5;                      // of CPU: a busy machine is no hang
constexpr long most_memory = 1 << 20;              // KiB resident
constexpr rlim_t address_space = rlim_t(6) << 30;  // beyond it bad_alloc: threads' stacks and arenas on a large machine need some of it

/// How a child ends.
enum Ending : int { success = 0, refused_input = 2, refused_memory = 4, two_lines = 96, wrong_kind = 97, foreign_exception = 98 };

/// Every channel of every part, in bands of a bounded size.
void read_everything(const fs::path& path, const relume::ReadLimits& limits) {
  const ExrFile file(path, limits);
  for (const relume::Part& part : file.parts()) {
    constexpr std::int64_t most_samples = 4 << 20;
    const std::int64_t row = std::int64_t(part.data_window.width()) * std::int64_t(std::max<std::size_t>(1, part.channels.size()));
    const int rows = int(std::clamp<std::int64_t>(most_samples / row, 1, part.data_window.height()));
    std::vector<float> samples(std::size_t(row * rows));
    for (int y = part.data_window.min_y; y < part.data_window.max_y; y += rows) {
      const Window band{part.data_window.min_x, y, part.data_window.max_x, std::min(y + rows, part.data_window.max_y)};
      std::vector<Destination> all;
      for (const relume::Channel& channel : part.channels)
        all.push_back(
            {channel.name, SampleType::float32, samples.data() + all.size() * std::size_t(band.pixels()), 4, std::size_t(band.width()) * 4});
      file.read(part.index, band, all);
    }
  }
}

int ending_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    if (std::string(error.what()).find_first_of("\n\r\x1b") != std::string::npos) return two_lines;
    return error.kind == ErrorKind::input || error.kind == ErrorKind::memory ? int(error.kind) : int(wrong_kind);
  } catch (...) {
    return foreign_exception;
  }
  return success;
}

struct End {
  int status = 0;
  long kibibytes = 0;
  bool allowed() const {
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return (code == success || code == refused_input || code == refused_memory) && (!memory_is_measured || kibibytes <= most_memory);
  }
  bool refused() const { return allowed() && WEXITSTATUS(status) != success; }
};

std::ostream& operator<<(std::ostream& out, const End& end) {
  if (WIFSIGNALED(end.status)) return out << "signal " << WTERMSIG(end.status);
  return out << "exit " << WEXITSTATUS(end.status) << ", " << end.kibibytes << " KiB";
}

End in_child(const std::function<void()>& work) {
  const pid_t child = fork();
  if (child == 0) {
    const rlimit cpu{seconds, seconds}, space{address_space, address_space}, no_core{0, 0};
    setrlimit(RLIMIT_CPU, &cpu);
    setrlimit(RLIMIT_CORE, &no_core);
    if (memory_is_measured) setrlimit(RLIMIT_AS, &space);
    alarm(60);  // a wait that burns no CPU
    _exit(ending_of(work));
  }
  End end;
  rusage usage{};
  wait4(child, &end.status, 0, &usage);
  end.kibibytes = usage.ru_maxrss;
  return end;
}

std::vector<fs::path> files_below(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".exr") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

TEST(Hostile, SmallFilesAreRefused) {
  const std::vector<fs::path> files = files_below(fs::path(RELUME_SOURCE) / "tests/data/hostile");
  ASSERT_GE(files.size(), 15u);
  for (const fs::path& file : files) {
    const End end = in_child([&] { read_everything(file, {}); });
    EXPECT_TRUE(end.refused()) << file.filename() << ": " << end;
  }
}

TEST(Hostile, WholeCorpusEndsInSuccessOrRefusal) {
  const fs::path corpus = fs::path(RELUME_CORPUS) / "bad-exr";
  if (!fs::exists(corpus)) GTEST_SKIP() << "no corpus beside the project";
  std::map<std::string, std::map<std::string, int>> counts;
  for (const fs::path& file : files_below(corpus)) {
    const End end = in_child([&] { read_everything(file, {}); });
    EXPECT_TRUE(end.allowed()) << file << ": " << end;
    std::ostringstream name;
    name << (end.refused() ? "refused" : end.allowed() ? "read" : "failed");
    ++counts[file.parent_path().filename()][name.str()];
    EXPECT_TRUE(end.refused() || file.parent_path().filename() != "disguised") << file;
  }
  for (const auto& [folder, ends] : counts) {
    std::cout << folder << ':';
    for (const auto& [name, count] : ends) std::cout << ' ' << name << ' ' << count;
    std::cout << '\n';
  }
  EXPECT_GE(counts["unusual"]["read"], 30);
}

/// Bytes of valid files changed at random: the header most, since there a byte goes furthest.
void mutate(std::string& bytes, std::mt19937& random) {
  const auto below = [&](std::size_t end) { return std::size_t(random() % end); };
  const std::size_t changes = 1 + below(4);
  for (std::size_t i = 0; i < changes; ++i) {
    const std::size_t at = below(random() % 4 ? std::min<std::size_t>(bytes.size(), 700) : bytes.size());
    constexpr unsigned char telling[] = {0, 1, 2, 0x7f, 0x80, 0xff};
    bytes[at] = char(random() % 2 ? telling[below(std::size(telling))] : random());
  }
  if (random() % 8 == 0) bytes.resize(below(bytes.size()) + 1);
}

TEST(Hostile, RandomChangesToValidFilesEndInSuccessOrRefusal) {
  const fs::path folder = fs::path(RELUME_SOURCE) / "tests/data/valid";
  const std::vector<fs::path> files = files_below(folder);
  ASSERT_GE(files.size(), 3u);
  std::string name = (fs::temp_directory_path() / "relume-hostile-XXXXXX").string();
  const fs::path work = mkdtemp(name.data());
  constexpr unsigned batches = 8;
  for (const fs::path& file : files) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    for (unsigned seed = 0; seed < batches; ++seed) {
      const End end = in_child([&] {
        std::mt19937 random(seed);
        for (int i = 0; i < 100; ++i) {
          std::string bytes = text.str();
          mutate(bytes, random);
          std::ofstream(work / "a.exr", std::ios::binary) << bytes;
          const int ending = ending_of([&] { read_everything(work / "a.exr", {.max_decoded_bytes = 64 << 20}); });
          if (ending != success && ending != refused_input && ending != refused_memory) _exit(ending);
        }
      });
      EXPECT_TRUE(end.allowed()) << file.filename() << ", seed " << seed << ": " << end << "; the file is " << work / "a.exr";
      if (HasFailure()) return;  // the file stays for a look
    }
  }
  fs::remove_all(work);
}

}  // namespace
