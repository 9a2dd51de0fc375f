#include "tools/canrec/commands/output.hpp"

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

namespace canrec {

namespace {

constexpr std::size_t kKept = 1 << 16;
constexpr mode_t kMode = 0666;

tl::unexpected<Failure> failed(std::string_view name) {
  return fail(Status::Failed, fmt::format("{}: {}", name, std::strerror(errno)));
}

}  // namespace

Expected<Output> Output::open(const std::string& path) {
  if (path.empty() || path == "-") return Output{"standard output", {}};
  os::Descriptor file{::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, kMode)};
  if (!file) return failed(path);
  return Output{path, std::move(file)};
}

Expected<void> Output::write(std::string_view text) {
  kept_ += text;
  return kept_.size() < kKept ? Expected<void>{} : flush();
}

Expected<void> Output::flush() {
  std::string_view rest = kept_;
  const int file = file_ ? file_.get() : STDOUT_FILENO;
  while (!rest.empty()) {
    const ssize_t written = ::write(file, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return failed(name_);
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  kept_.clear();
  return {};
}

Expected<void> Output::finish() {
  if (auto done = flush(); !done) return done;
  // Some file systems say only now that there was no room.
  if (file_ && ::fsync(file_.get()) != 0 && errno != EINVAL && errno != EROFS) return failed(name_);
  return {};
}

}  // namespace canrec
