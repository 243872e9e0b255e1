// Reads with pread and a small buffer. Not a memory map: a file cut short while it is read would end the process by SIGBUS.
#include "gbuffer/input_stream.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "gbuffer/error.h"
#include "gbuffer/printable.h"
#include "gbuffer/watched.h"

namespace relume {
namespace {

constexpr std::size_t buffer_bytes = 16384;  // holds a usual header; pixel data goes past it

std::string reason(int code) {
  if (code == ENOENT) return "no such file";
  if (code == EACCES) return "no permission to read";
  return std::strerror(code);
}

}  // namespace

InputStream::InputStream(const std::filesystem::path& file) : Imf::IStream(file.c_str()), name_(printable(file.native())) {
  // O_NONBLOCK: opening a FIFO that nobody writes to must not wait.
  descriptor_ = open(file.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  if (descriptor_ < 0) throw Error(ErrorKind::input, name_ + ": " + reason(errno));
  struct stat status {};
  const bool known = fstat(descriptor_, &status) == 0;
  if (known && S_ISREG(status.st_mode)) {
    size_ = std::uint64_t(status.st_size);
    return;
  }
  close(descriptor_);
  throw Error(ErrorKind::input, name_ + (S_ISDIR(status.st_mode) ? ": is a folder, not a file" : ": is not a regular file"));
}

InputStream::~InputStream() { close(descriptor_); }

bool InputStream::read_through(std::uint64_t position, char* data, std::size_t bytes) {
  while (bytes > 0) {
    const ssize_t got = pread(descriptor_, data, bytes, off_t(position));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw Error(ErrorKind::input, name_ + ": " + reason(errno));
    if (got == 0) return false;
    beat();
    data += got;
    position += std::uint64_t(got);
    bytes -= std::size_t(got);
  }
  return true;
}

bool InputStream::read_at(std::uint64_t position, void* data, std::size_t bytes) {
  if (position > size_ || bytes > size_ - position) return false;
  if (bytes >= buffer_bytes) return read_through(position, static_cast<char*>(data), bytes);
  const bool buffered = position >= buffer_start_ && position + bytes <= buffer_start_ + buffer_.size();
  if (!buffered) {
    buffer_.resize(std::size_t(std::min<std::uint64_t>(buffer_bytes, size_ - position)));
    buffer_start_ = position;
    if (!read_through(position, buffer_.data(), buffer_.size())) {
      buffer_.clear();
      return false;
    }
  }
  std::memcpy(data, buffer_.data() + (position - buffer_start_), bytes);
  return true;
}

bool InputStream::read(char data[], int bytes) {
  if (bytes < 0 || !read_at(position_, data, std::size_t(bytes))) throw std::runtime_error("the file ends early");
  position_ += std::uint64_t(bytes);
  return position_ < size_;
}

}  // namespace relume
