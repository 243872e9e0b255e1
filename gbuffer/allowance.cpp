// The soft limit goes down with the first allowance and back with the last.
#include "gbuffer/allowance.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <mutex>
#include <optional>

namespace relume {
namespace {

#if defined(__SANITIZE_ADDRESS__)
constexpr bool effective = false;  // AddressSanitizer ends the process where memory is refused
#elif defined(__has_feature)
constexpr bool effective = !__has_feature(address_sanitizer);
#else
constexpr bool effective = true;
#endif

std::mutex mutex;
int depth = 0;
std::optional<rlim_t> before;  ///< the limit to go back to, where one was set

/// Bytes that count against RLIMIT_DATA now, or 0 where /proc is not to be seen.
rlim_t data_now() {
  std::FILE* const statm = std::fopen("/proc/self/statm", "re");
  if (!statm) return 0;
  unsigned long pages = 0;  // the sixth number: data and stack
  const int got = std::fscanf(statm, "%*u %*u %*u %*u %*u %lu", &pages);
  std::fclose(statm);
  return got == 1 ? rlim_t(pages) * rlim_t(sysconf(_SC_PAGESIZE)) : 0;
}

}  // namespace

Allowance::Allowance(std::int64_t bytes) {
  const std::lock_guard lock(mutex);
  if (!effective || depth++ > 0) return;
  rlimit limit{};
  const rlim_t now = data_now();
  if (now == 0 || getrlimit(RLIMIT_DATA, &limit) != 0) return;
  before = limit.rlim_cur;
  limit.rlim_cur = std::min(limit.rlim_cur, now + rlim_t(bytes));
  setrlimit(RLIMIT_DATA, &limit);
}

Allowance::~Allowance() {
  const std::lock_guard lock(mutex);
  rlimit limit{};
  if (!effective || --depth > 0 || !before || getrlimit(RLIMIT_DATA, &limit) != 0) return;
  limit.rlim_cur = *before;
  setrlimit(RLIMIT_DATA, &limit);
  before.reset();
}

}  // namespace relume
