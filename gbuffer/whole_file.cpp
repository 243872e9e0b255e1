// Temporary, fsync, rename: after a crash or a full disk there is the old file or the new one, never a part (research: reliability, section 5).
#include "gbuffer/whole_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <utility>

#include "gbuffer/error.h"
#include "gbuffer/printable.h"
#include "gbuffer/temporaries.h"
#include "gbuffer/watched.h"

namespace relume {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t buffer_bytes = 1 << 20;  // scan lines arrive in pieces of a few bytes

std::string reason(int code) {
  if (code == ENOSPC) return "disk full";
  if (code == EDQUOT) return "disk quota used up";
  if (code == EFBIG) return "the file grows beyond what this process or disk allows";
  if (code == ENOENT) return "no such folder";
  if (code == EACCES || code == EPERM) return "no permission to write there";
  if (code == EROFS) return "the disk is read-only";
  if (code == EEXIST) return "exists (--overwrite replaces it)";
  return std::strerror(code);
}

/// A write beyond RLIMIT_FSIZE ends the process by SIGXFSZ unless it is ignored; then write() says EFBIG, which we can report.
void report_size_limit() {
  static const bool done = [] {
    struct sigaction now {};
    if (sigaction(SIGXFSZ, nullptr, &now) == 0 && now.sa_handler == SIG_DFL) std::signal(SIGXFSZ, SIG_IGN);
    return true;
  }();
  static_cast<void>(done);
}

void sync_folder(const fs::path& folder) noexcept {
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  // The file is whole and in place: a file system that cannot sync folders only leaves open which name survives a power cut.
  static_cast<void>(fsync(descriptor));
  close(descriptor);
}

}  // namespace

WholeFile::WholeFile(const fs::path& file, bool overwrite) : name_(printable(file.native())), overwrite_(overwrite) {
  std::error_code code;
  file_ = fs::absolute(file, code);  // a change of the working folder must not move the target
  if (code || file_.filename().empty()) throw Error(ErrorKind::output, name_ + ": names no file");
  check_target();
  report_size_limit();
  create_temporary();
  buffer_.reserve(buffer_bytes);
}

WholeFile::~WholeFile() { discard(); }

void WholeFile::fail(int code) const { throw Error(ErrorKind::output, name_ + ": " + reason(code)); }

void WholeFile::check_target() {
  struct stat status {};
  if (lstat(file_.c_str(), &status) != 0) {
    if (errno != ENOENT) fail(errno);
    return;
  }
  if (!overwrite_) fail(EEXIST);
  if (S_ISLNK(status.st_mode)) {
    // The link stays and its target is replaced, as a plain write would do.
    std::error_code code;
    file_ = fs::canonical(file_, code);
    if (code || stat(file_.c_str(), &status) != 0) throw Error(ErrorKind::output, name_ + ": is a link that leads nowhere");
  }
  if (!S_ISREG(status.st_mode)) throw Error(ErrorKind::output, name_ + ": is not a regular file, and nothing else is replaced");
  mode_ = int(status.st_mode & 0777);
}

void WholeFile::create_temporary() {
  // A leftover of a killed process that had our number, or a second writer of this name in our process, takes a number more.
  constexpr int attempts = 100;
  constexpr std::size_t longest_stem = 220;  // of NAME_MAX 255: room for the process and attempt numbers
  const std::string stem = '.' + file_.filename().native().substr(0, longest_stem) + '.' + std::to_string(getpid());
  for (int i = 0; i < attempts && descriptor_ < 0; ++i) {
    temporary_ = file_.parent_path() / (stem + (i ? '.' + std::to_string(i) : "") + ".tmp");
    // Noted before it exists: an interrupt in between must find it.
    slot_ = note_temporary(temporary_);
    if (slot_ < 0) throw Error(ErrorKind::output, name_ + ": too long a path, or too many files being written at once");
    descriptor_ = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, mode_);
    const int code = errno;
    if (descriptor_ >= 0) return;
    forget_temporary(std::exchange(slot_, -1));
    if (code != EEXIST) fail(code);
  }
  throw Error(ErrorKind::output, name_ + ": " + std::to_string(attempts) + " unfinished temporaries lie beside it");
}

void WholeFile::flush() {
  const char* data = buffer_.data();
  std::size_t bytes = buffer_.size();
  while (bytes > 0) {
    const ssize_t written = ::write(descriptor_, data, bytes);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(errno);
    beat();
    data += written;
    bytes -= std::size_t(written);
    position_ += std::uint64_t(written);
  }
  buffer_.clear();
}

void WholeFile::write(const void* data, std::size_t bytes) {
  const char* from = static_cast<const char*>(data);
  while (bytes > 0) {
    const std::size_t piece = std::min(bytes, buffer_bytes - buffer_.size());
    buffer_.insert(buffer_.end(), from, from + piece);
    from += piece;
    bytes -= piece;
    if (buffer_.size() == buffer_bytes) flush();
  }
}

void WholeFile::seek(std::uint64_t position) {
  flush();
  if (lseek(descriptor_, off_t(position), SEEK_SET) < 0) fail(errno);
  position_ = position;
}

std::uint64_t WholeFile::position() const { return position_ + buffer_.size(); }

const fs::path& WholeFile::temporary() const { return temporary_; }

void WholeFile::commit(const std::function<void(const fs::path&)>& verify) {
  flush();
  if (overwrite_ && mode_ != 0666) static_cast<void>(fchmod(descriptor_, mode_t(mode_)));  // umask may have taken bits that the old file had
  if (fsync(descriptor_) != 0) fail(errno);
  if (close(std::exchange(descriptor_, -1)) != 0) fail(errno);
  if (verify) verify(temporary_);
  put_in_place();
  forget_temporary(std::exchange(slot_, -1));
  sync_folder(file_.parent_path());
}

void WholeFile::put_in_place() {
  if (overwrite_) {
    if (rename(temporary_.c_str(), file_.c_str()) != 0) fail(errno);
    return;
  }
  if (renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, file_.c_str(), RENAME_NOREPLACE) == 0) return;
  if (errno != EINVAL && errno != ENOSYS) fail(errno);
  // Network file systems know no such rename; a hard link does not replace either.
  if (link(temporary_.c_str(), file_.c_str()) != 0) fail(errno);
  unlink(temporary_.c_str());
}

void WholeFile::discard() noexcept {
  if (descriptor_ >= 0) close(std::exchange(descriptor_, -1));
  if (slot_ < 0) return;
  unlink(temporary_.c_str());
  forget_temporary(std::exchange(slot_, -1));
}

void write_whole(const std::filesystem::path& file, const std::string& bytes, bool overwrite) {
  WholeFile whole(file, overwrite);
  whole.write(bytes.data(), bytes.size());
  whole.commit();
}

}  // namespace relume
