#include "record/output_file.hpp"

#include <cerrno>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace record {
namespace {

constexpr std::size_t kBuffer = std::size_t{64} << 10;

}  // namespace

OutputFile::OutputFile() {
  buffer_.reserve(kBuffer);
}

int OutputFile::open(const std::string& path) noexcept {
  constexpr mode_t kOwnerOnly = S_IRUSR | S_IWUSR;
  buffer_.clear();
  size_ = 0;
  if (::unlink(path.c_str()) != 0 && errno != ENOENT) return errno;
  file_ = os::Descriptor{::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, kOwnerOnly)};
  return file_ ? 0 : errno;
}

int OutputFile::write(std::span<const std::byte> bytes) noexcept {
  size_ += bytes.size();
  while (!bytes.empty()) {
    const std::span part = bytes.first(std::min(bytes.size(), kBuffer - buffer_.size()));
    buffer_.insert(buffer_.end(), part.begin(), part.end());
    bytes = bytes.subspan(part.size());
    if (buffer_.size() < kBuffer) continue;
    if (const int error = flush()) return error;
  }
  return 0;
}

int OutputFile::flush() noexcept {
  std::span<const std::byte> rest = buffer_;
  while (!rest.empty()) {
    const ssize_t written = ::write(file_.get(), rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return written < 0 ? errno : ENOSPC;
    rest = rest.subspan(static_cast<std::size_t>(written));
  }
  buffer_.clear();
  return 0;
}

void OutputFile::close() noexcept {
  file_ = os::Descriptor{};
  buffer_.clear();
}

}  // namespace record
