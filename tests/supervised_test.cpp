// What the program makes of code that is not ours and fails: decoders and drivers that crash, end the process, stand still or eat memory.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <chrono>
#include <thread>

#include "tests/make_gbuffer.h"
#include "tests/run_program.h"
#include "tests/under_asan.h"

namespace relume {
namespace {

namespace fs = std::filesystem;

class Supervised : public testing::Test {
 protected:
  void SetUp() override {
    if (under_asan) GTEST_SKIP() << "AddressSanitizer takes crashes and memory into its own hands";
    write_gbuffer(in("g.exr"), {});
    std::ofstream(in("rig.json")) << rig;
  }

  std::string in(const std::string& name) const { return (inputs_ / name).string(); }
  std::string out() const { return (outputs_ / "out.exr").string(); }
  bool nothing_left() const { return fs::is_empty(outputs_.path()); }

  /// Without --device twin: an OpenCL device, where the environment has one.
  std::vector<std::string> shade(std::vector<std::string> options = {}) const {
    std::vector<std::string> all{"shade", in("g.exr"), "--lights", in("rig.json"), "-o", out()};
    all.insert(all.end(), options.begin(), options.end());
    return all;
  }
  static std::string decoder(const std::string& fault) {
    return "RELUME_TIMEOUT=1 RELUME_FAULT=" + fault + " LD_PRELOAD=" RELUME_FAULTS "/zlib_fault.so";
  }
  std::string driver(const std::string& fault) const {
    return "RELUME_TIMEOUT=1 RELUME_FAULT=" + fault +
           " OCL_ICD_VENDORS=" RELUME_FAULTS "/driver_fault.so OCL_ICD_FILENAMES=" RELUME_FAULTS "/driver_fault.so XDG_CACHE_HOME=" +
           shell_quoted(inputs_.path().string());
  }

  static constexpr const char* rig = R"({"relume": 1, "lights": [{"type": "point", "position": [2, 3, 4], "intensity": [40, 38, 35]}]})";
  TemporaryFolder inputs_, outputs_;
};

TEST_F(Supervised, ADecoderThatFailsIsTheFilesFault) {
  const std::string decoding = "relume: " + in("g.exr") + ": part 0: OpenEXR, which decodes it, ",
                    why = ": the file is damaged, or made to do this; nothing was written\n";
  const std::pair<const char*, std::string> faults[] = {{"crash", "crashed (signal 6)"},
                                                        {"exit", "ended the program (exit code 1)"},
                                                        {"spin", "made no progress for 1 s (RELUME_TIMEOUT=SECONDS sets another limit, 0 none)"}};
  for (const auto& [fault, what] : faults)
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"inspect", in("g.exr")}, {"compare", in("g.exr"), in("g.exr")}, shade({"--device", "twin"})}) {
      const ProgramRun run = run_program(arguments, {}, decoder(fault));
      EXPECT_EQ(run.code, 2) << fault << ": " << arguments[0];
      EXPECT_EQ(run.err, decoding + what + why);
      EXPECT_EQ(run.out, "");
      EXPECT_TRUE(nothing_left());
    }
}

TEST_F(Supervised, ADecoderThatEatsMemoryIsStopped) {
  MadeUpGBuffer made;
  made.compression = Imf::PXR24_COMPRESSION;
  write_gbuffer(in("g.exr"), made);
  const ProgramRun run = run_program(shade({"--device", "twin"}), {}, decoder("memory"));
  EXPECT_EQ(run.code, 4);
  EXPECT_EQ(run.err, "relume: " + in("g.exr") + ": part 0: damaged pixel data: not enough memory to decode it\n");
  EXPECT_TRUE(nothing_left());
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  EXPECT_LT(usage.ru_maxrss, 1 << 20) << "KiB";
}

TEST_F(Supervised, ADriverThatTakesTheProcessDownIsDoneWithout) {
  for (const char* fault : {"crash", "exit"}) {
    const ProgramRun run = run_program(shade({"--overwrite"}), {}, driver(fault));
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_NE(
        run.err.find(
            "note: the OpenCL driver crashed, and again with nothing compiled before (--device twin needs none); shading on the C++ twin instead\n"),
        std::string::npos)
        << run.err;
    EXPECT_TRUE(fs::exists(out()));
  }
}

TEST_F(Supervised, ADriverAskedForByNameIsAnError) {
  const ProgramRun named = run_program(shade({"--device", "gpu"}), {}, driver("crash"));
  EXPECT_EQ(named.code, 3);
  EXPECT_EQ(named.err, "relume: the OpenCL driver crashed, and again with nothing compiled before (--device twin needs none)\n");
  // A rig that came through a pipe is gone: no second attempt.
  std::vector<std::string> piped = shade();
  piped[3] = "-";
  const ProgramRun once = run_program(piped, rig, driver("crash"));
  EXPECT_EQ(once.code, 3);
  EXPECT_EQ(once.err, "relume: the OpenCL driver crashed (signal 6); nothing was written (--device twin needs no driver)\n");
  const ProgramRun stands = run_program(shade(), {}, driver("stand"));
  EXPECT_EQ(stands.code, 3);
  EXPECT_EQ(stands.err,
            "relume: the OpenCL driver made no progress for 5 s (RELUME_TIMEOUT=SECONDS sets another limit, 0 none); nothing was written "
            "(--device twin needs no driver)\n");
  EXPECT_TRUE(nothing_left());
}

/// PoCL maps the programs that it compiled before without a look at their size: a truncated one is a SIGBUS.
TEST_F(Supervised, ADamagedDriverCacheHealsItself) {
  const std::string before = "XDG_CACHE_HOME=" + shell_quoted(inputs_.path().string());
  const ProgramRun first = run_program(shade(), {}, before);
  ASSERT_EQ(first.code, 0) << first.err;
  int damaged = 0;
  for (const auto& entry : fs::recursive_directory_iterator(inputs_.path()))
    if (entry.path().extension() == ".so") fs::resize_file(entry.path(), 4096), ++damaged;
  if (damaged == 0) GTEST_SKIP() << "no driver here that keeps compiled programs as shared objects";
  const ProgramRun again = run_program(shade({"--overwrite"}), {}, before);
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(again.err.find("twin"), std::string::npos) << again.err;
}

/// The program, with an output begun; minutes of work.
class Running {
 public:
  Running(std::vector<std::string> arguments, const fs::path& outputs) {
    pid = fork();
    if (pid == 0) {
      std::vector<char*> words{const_cast<char*>(RELUME_PROGRAM)};
      for (std::string& word : arguments) words.push_back(word.data());
      words.push_back(nullptr);
      execv(RELUME_PROGRAM, words.data());
      _exit(127);
    }
    for (int i = 0; i < 1000 && fs::is_empty(outputs); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  pid_t worker() const { return std::atoi(text_of_file("/proc/" + std::to_string(pid) + "/task/" + std::to_string(pid) + "/children").c_str()); }

  pid_t pid;
};

TEST_F(Supervised, KillingEitherProcessLeavesNothing) {
  write_gbuffer(in("g.exr"), MadeUpGBuffer::of_size(2048, 2048));
  std::string lights;
  for (int k = 0; k < 20000; ++k) lights += (k ? "," : "") + std::string(R"({"type": "point", "position": [2, 3, 4], "intensity": [1, 1, 1]})");
  std::ofstream(in("rig.json")) << R"({"relume": 1, "lights": [)" + lights + "]}";
  for (const bool parent : {false, true}) {
    const Running program(shade({"--device", "twin", "--quiet"}), outputs_.path());
    const pid_t worker = program.worker();
    ASSERT_GT(worker, 0);
    ASSERT_FALSE(nothing_left()) << "no output was begun";
    kill(parent ? program.pid : worker, SIGKILL);
    int status = 0;
    waitpid(program.pid, &status, 0);
    if (!parent) {
      EXPECT_EQ(WEXITSTATUS(status), 4);
    }
    for (int i = 0; i < 500 && (!nothing_left() || kill(worker, 0) == 0); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_TRUE(nothing_left());
    EXPECT_NE(kill(worker, 0), 0) << "the worker outlived its parent";
  }
}

/// Interactive use: a table typed in slowly, and a reader that takes its time, are no standstill.
TEST_F(Supervised, WaitingForAPipeIsNoStandstill) {
  const std::string program = shell_quoted(RELUME_PROGRAM);
  const std::string slow = "(sleep 4; printf 'n_l,n_v,l_v\\n0.7,0.8,0.9\\n') | RELUME_TIMEOUT=1 " + program +
                           " evaluate ggx --set roughness=0.4 --device twin > " + shell_quoted(in("table"));
  EXPECT_EQ(std::system(slow.c_str()), 0);
  EXPECT_NE(text_of_file(in("table")).find("reflectance"), std::string::npos);
}

}  // namespace
}  // namespace relume
