// cache_folder: found, made or replaced by a temporary one; prepare_driver_environment: variables that users have not set themselves.
#include "host/driver_environment.h"

#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <optional>
#include <string>

#include "gbuffer/watched.h"

namespace relume {
namespace {

namespace fs = std::filesystem;

bool is_private(const fs::path& folder) {
  struct stat status;
  return lstat(folder.c_str(), &status) == 0 && S_ISDIR(status.st_mode) && status.st_uid == geteuid() && (status.st_mode & 077) == 0 &&
         access(folder.c_str(), W_OK) == 0;
}

std::optional<fs::path> user_cache() {
  const char* base = std::getenv("XDG_CACHE_HOME");
  const char* home = std::getenv("HOME");
  if (!(base && *base == '/') && !(home && *home == '/')) return {};
  const fs::path parent = base && *base == '/' ? fs::path(base) : fs::path(home) / ".cache";
  const fs::path folder = parent / "relume";
  std::error_code ignored;
  fs::create_directories(parent, ignored);
  mkdir(folder.c_str(), 0700);
  if (!is_private(folder)) return {};
  return folder;
}

/// Removed when the program ends: what was compiled is lost, nothing else is.
struct TemporaryFolder {
  fs::path path;
  ~TemporaryFolder() {
    std::error_code ignored;
    if (!path.empty()) fs::remove_all(path, ignored);
  }
};

}  // namespace

const fs::path& cache_folder() {
  static TemporaryFolder temporary;
  static const fs::path folder = [] {
    if (const auto found = user_cache()) return *found;
    std::string name = (fs::temp_directory_path() / "relume-XXXXXX").string();
    if (const char* made = mkdtemp(name.data())) temporary.path = made;
    if (temporary.path.native().size() < sizeof watched().folder) std::strcpy(watched().folder, temporary.path.c_str());
    return temporary.path;
  }();
  return folder;
}

namespace {

void set_pocl_cache() {
  if (std::getenv("POCL_CACHE_DIR")) return;
  const fs::path folder = cache_folder() / "pocl";
  mkdir(folder.c_str(), 0700);
  if (is_private(folder)) setenv("POCL_CACHE_DIR", folder.c_str(), 0);
}

/// hwloc's synthetic topology: as many cores and as much memory as the kernel says.
void describe_machine() {
  if (fs::exists("/sys/devices/system/cpu") || std::getenv("HWLOC_XMLFILE")) return;
  const long cores = sysconf(_SC_NPROCESSORS_ONLN), pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGE_SIZE);
  if (cores < 1 || pages < 1 || page < 1) return;
  const std::string machine = "node:1(memory=" + std::to_string(pages * page) + ") pu:" + std::to_string(cores);
  setenv("HWLOC_SYNTHETIC", machine.c_str(), 0);
}

std::atomic<bool> distrusted{false};

}  // namespace

void forget_compiled_programs() {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(cache_folder(), ignored)) fs::remove_all(entry.path(), ignored);
}

void distrust_drivers() { distrusted = true; }
bool drivers_are_distrusted() { return distrusted; }

void prepare_driver_environment() {
  static std::once_flag once;
  std::call_once(once, [] {
    set_pocl_cache();
    describe_machine();
  });
}

}  // namespace relume
