#include "tools/axisctl/scenario/run/workshop.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

namespace scenario {
namespace {

std::string home_of_folders() {
  const char* const runtime = std::getenv("XDG_RUNTIME_DIR");
  if (runtime != nullptr && *runtime == '/') return runtime;
  std::error_code error;
  const std::filesystem::path temporary = std::filesystem::temp_directory_path(error);
  return error ? "/tmp" : temporary.string();
}

/// The process beside: listens until this program is gone, then tidies up.
[[noreturn]] void keep_house(const std::string& folder, bool keep, int pipe) {
  ::setsid();
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) std::signal(signal, SIG_IGN);
  const int null = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(null, standard);
  std::set<pid_t> groups;
  pid_t number = 0;
  while (true) {
    const ssize_t size = ::read(pipe, &number, sizeof number);
    if (size < 0 && errno == EINTR) continue;
    if (size != static_cast<ssize_t>(sizeof number)) break;
    if (number > 0)
      groups.insert(number);
    else
      groups.erase(-number);
  }
  for (const pid_t group : groups) ::kill(-group, SIGKILL);
  std::error_code ignored;
  if (!keep) std::filesystem::remove_all(folder, ignored);
  std::_Exit(0);
}

}  // namespace

tl::expected<Workshop, std::string> Workshop::open(bool keep) {
  std::string folder = home_of_folders() + "/axisctl-run-XXXXXX";
  std::array<int, 2> pipe{};
  if (::mkdtemp(folder.data()) == nullptr || ::pipe2(pipe.data(), O_CLOEXEC) != 0)
    return tl::unexpected{fmt::format("{}: {}", folder, std::generic_category().message(errno))};
  const pid_t keeper = ::fork();
  if (keeper == 0) {
    ::close(pipe[1]);
    keep_house(folder, keep, pipe[0]);
  }
  ::close(pipe[0]);
  return Workshop{std::move(folder), keep, os::Descriptor{pipe[1]}, keeper};
}

Workshop::Workshop(Workshop&& other) noexcept
    : folder_{std::move(other.folder_)},
      keep_{other.keep_},
      pipe_{std::move(other.pipe_)},
      keeper_{std::exchange(other.keeper_, 0)} {}

Workshop::~Workshop() {
  pipe_ = os::Descriptor{};  // the process beside sees it
  if (keeper_ > 0) ::waitpid(keeper_, nullptr, 0);
}

void Workshop::tell(pid_t number) const noexcept {
  [[maybe_unused]] const ssize_t written = ::write(pipe_.get(), &number, sizeof number);
}

}  // namespace scenario
