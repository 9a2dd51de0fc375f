#include "tools/regular_file.hpp"

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace tools {
namespace {

/// A descriptor that is closed at the end.
class OpenFile {
 public:
  explicit OpenFile(const std::string& path)
      : descriptor_{open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)} {}
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  [[nodiscard]] int descriptor() const noexcept { return descriptor_; }

 private:
  int descriptor_;
};

}  // namespace

tl::expected<std::string, std::string> read_regular_file(const std::string& path, std::size_t most) {
  const auto refuse = [&path](std::string_view reason) {
    return tl::unexpected{fmt::format("{}: cannot be read: {}", path, reason)};
  };
  const OpenFile file{path};
  struct stat status {};
  if (file.descriptor() < 0 || fstat(file.descriptor(), &status) != 0) return refuse(std::strerror(errno));
  if (!S_ISREG(status.st_mode)) return refuse("expected a regular file");
  const std::string too_large = fmt::format("expected at most {} MiB", most >> 20U);
  if (static_cast<std::size_t>(status.st_size) > most) return refuse(too_large);
  std::string text;
  constexpr std::size_t kChunk = 65536;
  while (true) {  // a file of /proc says that it is empty, another may grow
    const std::size_t before = text.size();
    text.resize(before + kChunk);
    const ssize_t count = read(file.descriptor(), text.data() + before, kChunk);
    if (count < 0 && errno != EINTR) return refuse(std::strerror(errno));
    text.resize(before + static_cast<std::size_t>(count < 0 ? 0 : count));
    if (text.size() > most) return refuse(too_large);
    if (count == 0) return text;
  }
}

}  // namespace tools
