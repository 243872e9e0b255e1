// Parent and child share gbuffer/watched.h's page and the list of temporaries; the parent waits for signals, a second at a time.
#include "cli/supervised.h"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <string>
#include <utility>

#include "gbuffer/error.h"
#include "gbuffer/watched.h"
#include "gbuffer/whole_file.h"
#include "host/driver_environment.h"

namespace relume {
namespace {

constexpr double longest_header = 5;  // seconds of processor time: OpenEXR parses the largest header that we let through in a fraction of one
constexpr int longest_tidying = 10;   // seconds, after the job's end: drivers close, and some never do
constexpr int attempts = 3;           // as it is; with nothing compiled kept; without drivers

/// Seconds without progress; 0: any number. Compilers of drivers take their time: rusticl up to 76 s for a program (docs/portability.md).
int patience() {
  const char* const text = std::getenv("RELUME_TIMEOUT");
  return (text && *text ? std::clamp(std::atoi(text), 0, 1 << 20) : 60) * (watched().now() == Foreign::driver ? 5 : 1);
}

/// How a child came to its end.
struct End {
  int status = 0;      ///< as waitpid gives it
  bool stuck = false;  ///< we ended it
};

/// Signals that are the parent's to pass on, and the child's end. Ignored ones (nohup's SIGHUP) stay ignored.
sigset_t awaited_signals() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGCHLD);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
    struct sigaction now {};
    if (sigaction(signal, nullptr, &now) == 0 && now.sa_handler != SIG_IGN) sigaddset(&set, signal);
  }
  return set;
}

/// Notices when the child no longer gets on. Counts its own waits, not a clock: a machine asleep or a job stopped by Ctrl-Z is no standstill.
class Watchdog {
 public:
  explicit Watchdog(pid_t child) : known_(clock_getcpuclockid(child, &clock_) == 0) {}

  /// Once a second: true where it has to be ended.
  bool stuck() {
    const Watched& w = watched();
    const double used = processor_seconds();
    if (const std::uint64_t beats = w.beats.load(); beats != beats_ || w.finished != finished_) {
      beats_ = beats;
      finished_ = w.finished;
      used_at_beat_ = used_ = used;
      silent_ = 0;
      return false;
    }
    silent_ += counted(used - std::exchange(used_, used));
    if (finished_) return silent_ >= longest_tidying;
    const int most = patience();
    return most > 0 && (silent_ >= most || (w.now() == Foreign::header && used - used_at_beat_ > std::min(longest_header, double(most))));
  }

 private:
  /// How much of a second counts: what the child had of the processor, for on a busy machine it waits through no fault of its own. Where it used
  /// none, foreign code stands still, and ours waits for a pipe.
  double counted(double used) const {
    constexpr double next_to_nothing = 0.05;
    if (used > next_to_nothing) return std::min(used, 1.0);
    return watched().now() != Foreign::none || finished_ ? 1 : 0;
  }

  double processor_seconds() const {
    timespec time{};
    return known_ && clock_gettime(clock_, &time) == 0 ? double(time.tv_sec) + 1e-9 * double(time.tv_nsec) : 0;
  }

  clockid_t clock_{};
  const bool known_;
  std::uint64_t beats_ = 0;
  bool finished_ = false;
  double used_ = 0, used_at_beat_ = 0, silent_ = 0;
};

End wait_for(pid_t child, const sigset_t& awaited) {
  Watchdog watchdog(child);
  End end;
  for (;;) {
    const timespec second{1, 0};
    const int signal = sigtimedwait(&awaited, nullptr, &second);
    if (waitpid(child, &end.status, WNOHANG) == child) return end;
    if (signal > 0 && signal != SIGCHLD) kill(child, signal);
    if (signal < 0 && watchdog.stuck() && !end.stuck) end.stuck = kill(child, SIGKILL) == 0;
  }
}

/// The child's side: the job, and its code where the parent sees it before anything that is tidied up can fail.
int in_child(const std::function<int()>& job, int attempt, pid_t parent, const sigset_t& mask) {
  prctl(PR_SET_PDEATHSIG, SIGTERM);  // a parent that is killed takes its job along
  if (getppid() != parent) std::raise(SIGTERM);
  sigprocmask(SIG_SETMASK, &mask, nullptr);
  if (attempt > 0) forget_compiled_programs();
  if (attempt + 1 == attempts) distrust_drivers();
  const int code = job();
  std::cout.flush();
  std::fflush(nullptr);
  watched().finish(code);
  return code;
}

/// Nothing of the child's remains: temporaries, and the folder that a driver compiled into.
void sweep() {
  remove_temporaries();
  std::error_code ignored;
  if (watched().folder[0] != '\0') std::filesystem::remove_all(watched().folder, ignored);
  watched().folder[0] = '\0';
}

int say(const std::string& line, ErrorKind kind) {
  if (isatty(STDERR_FILENO)) std::cerr << "\r\033[K";  // the child's progress bar
  std::cerr << "relume: " << line << "\n";
  return int(kind);
}

/// "crashed (signal 11)"; or a library called exit().
std::string what_happened(const End& end) {
  if (end.stuck) return "made no progress for " + std::to_string(patience()) + " s (RELUME_TIMEOUT=SECONDS sets another limit, 0 none)";
  if (WIFSIGNALED(end.status)) return "crashed (signal " + std::to_string(WTERMSIG(end.status)) + ")";
  return "ended the program (exit code " + std::to_string(WEXITSTATUS(end.status)) + ")";
}

bool is_crash(int signal) {
  constexpr int crashes[] = {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGSYS};
  return std::find(std::begin(crashes), std::end(crashes), signal) != std::end(crashes);
}

/// The line and the code for what was no regular end.
int explain(const End& end) {
  const Watched& w = watched();
  const std::string file = w.file;
  if (!end.stuck && WIFSIGNALED(end.status) && !is_crash(WTERMSIG(end.status))) {
    if (WTERMSIG(end.status) == SIGKILL)
      return say("killed, most likely by the system for want of memory (--memory makes bands smaller); nothing was written", ErrorKind::memory);
    std::signal(WTERMSIG(end.status), SIG_DFL);  // SIGPIPE, SIGXCPU and the like: what ended the job ends us the same way
    sigset_t all;
    sigfillset(&all);
    sigprocmask(SIG_UNBLOCK, &all, nullptr);
    std::raise(WTERMSIG(end.status));
  }
  const std::string what = what_happened(end);
  if (w.now() == Foreign::header && end.stuck)
    return say(file + ": its header keeps OpenEXR busy without an end: damaged, or made to", ErrorKind::input);
  if (w.now() == Foreign::header || w.now() == Foreign::pixels)
    return say(file + ": OpenEXR, which decodes it, " + what + ": the file is damaged, or made to do this; nothing was written", ErrorKind::input);
  if (w.now() == Foreign::mesh)
    return say(file + ": Assimp, which reads it, " + what + ": the file is damaged, or made to do this; nothing was written", ErrorKind::input);
  if (w.now() == Foreign::driver || w.driver_loaded)
    return say("the OpenCL driver " + what + "; nothing was written (--device twin needs no driver)", ErrorKind::device);
  return say("a defect of ours: the program " + what + "; nothing was written", ErrorKind::internal);
}

/// A driver's crash may lie in what it compiled before, or in the driver; standard input cannot be read twice.
bool worth_another(const End& end) {
  const Watched& w = watched();
  const bool died = WIFSIGNALED(end.status) ? is_crash(WTERMSIG(end.status)) : true;
  const bool decoding = w.now() == Foreign::header || w.now() == Foreign::pixels;
  return died && !end.stuck && w.driver_loaded && !decoding && !w.input_used;
}

}  // namespace

int supervised(const std::function<int()>& job) {
  std::signal(SIGCHLD, SIG_DFL);  // ignored, by a caller's leave, it would take the child's status with it
  const sigset_t awaited = awaited_signals();
  sigset_t before;
  sigprocmask(SIG_BLOCK, &awaited, &before);
  const pid_t parent = getpid();
  for (int attempt = 0;; ++attempt) {
    watched().reset();
    const pid_t child = fork();
    if (child < 0) sigprocmask(SIG_SETMASK, &before, nullptr);
    if (child < 0) return job();
    if (child == 0) return in_child(job, attempt, parent, before);
    const End end = wait_for(child, awaited);
    sweep();
    if (watched().finished) return WIFEXITED(end.status) ? WEXITSTATUS(end.status) : watched().code.load();
    if (attempt + 1 == attempts || !worth_another(end)) return explain(end);
  }
}

}  // namespace relume
