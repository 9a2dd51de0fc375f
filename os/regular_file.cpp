#include "os/regular_file.hpp"

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "os/descriptor.hpp"

namespace os {
namespace {

using Why = UnreadableFile::Why;

tl::unexpected<UnreadableFile> failed(int error) {
  return tl::unexpected{UnreadableFile{Why::System, error}};
}

/// Opens what is at @p path for reading, without waiting for a writer of a FIFO.
int open_to_read(const std::string& path) noexcept {
  int descriptor = -1;
  do {
    descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  } while (descriptor < 0 && errno == EINTR);
  return descriptor;
}

}  // namespace

bool UnreadableFile::is_missing() const noexcept {
  return error == ENOENT;
}

std::string UnreadableFile::reason() const {
  return why == Why::NotRegular ? "Not a regular file" : std::strerror(error);
}

tl::expected<std::string, UnreadableFile> read_regular_file(const std::string& path, std::size_t most) {
  const Descriptor file{open_to_read(path)};
  struct stat status {};
  if (!file || ::fstat(file.get(), &status) != 0) return failed(errno);
  if (S_ISDIR(status.st_mode)) return failed(EISDIR);
  if (!S_ISREG(status.st_mode)) return tl::unexpected{UnreadableFile{Why::NotRegular, 0}};
  std::string content;
  while (true) {  // a file of /proc says that it is empty, another may grow
    constexpr std::size_t kBlock = 65536;
    const std::size_t before = content.size();
    content.resize(before + kBlock);
    const ssize_t got = ::read(file.get(), &content[before], kBlock);
    const int error = got < 0 ? errno : 0;
    content.resize(before + static_cast<std::size_t>(got > 0 ? got : 0));
    if (error == EINTR) continue;
    if (error != 0) return failed(error);
    if (content.size() > most) return tl::unexpected{UnreadableFile{Why::TooLong, EFBIG}};
    if (got == 0) return content;
  }
}

}  // namespace os
