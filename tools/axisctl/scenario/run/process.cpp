#include "tools/axisctl/scenario/run/process.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace scenario {
namespace {

constexpr int kOfSignals = 128;
constexpr mode_t kPrivate = 0600;
/// Patience with a child that was asked to end.
constexpr std::chrono::milliseconds kPatience{2000}, kPause{2};

/// In the child: becomes the program; on failure errno goes to @p complaint.
[[noreturn]] void become(const Command& command, std::vector<char*>& words, pid_t parent, int complaint) {
  const auto give_up = [complaint] {
    const int error = errno;
    [[maybe_unused]] const ssize_t written = ::write(complaint, &error, sizeof error);
    std::_Exit(kOfSignals - 1);
  };
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) std::_Exit(0);
  for (const int signal : {SIGINT, SIGTERM, SIGPIPE}) std::signal(signal, SIG_DFL);
  const int input = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  const int log = ::open(command.log.empty() ? "/dev/null" : command.log.c_str(),
                         O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, kPrivate);
  if (input < 0 || log < 0) give_up();
  ::dup2(input, STDIN_FILENO);
  ::dup2(log, STDOUT_FILENO);
  ::dup2(log, STDERR_FILENO);
  for (const auto& [name, value] : command.environment) ::setenv(name.c_str(), value.c_str(), 1);
  ::execvp(words.front(), words.data());
  give_up();
  std::_Exit(kOfSignals - 1);
}

}  // namespace

tl::expected<Process, std::string> Process::start(const Command& command) {
  std::vector<char*> words;
  for (const std::string& word : command.words) words.push_back(const_cast<char*>(word.c_str()));  // NOLINT
  words.push_back(nullptr);
  std::array<int, 2> pipe{};
  const auto failed = [&command](int error) {
    return tl::unexpected{
        fmt::format("{}: cannot be started: {}", command.words.front(), std::generic_category().message(error))};
  };
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) return failed(errno);
  const pid_t parent = ::getpid(), child = ::fork();
  if (child == 0) become(command, words, parent, pipe[1]);
  ::close(pipe[1]);
  int error = child < 0 ? errno : 0;
  if (child > 0 && ::read(pipe[0], &error, sizeof error) == static_cast<ssize_t>(sizeof error))
    ::waitpid(child, nullptr, 0);
  ::close(pipe[0]);
  if (error != 0) return failed(error);
  ::setpgid(child, child);
  return Process{child, command.log};
}

std::optional<int> Process::ended() noexcept {
  int status = 0;
  if (ended_ || process_ == 0 || ::waitpid(process_, &status, WNOHANG) != process_) return ended_;
  ended_ = WIFEXITED(status) ? WEXITSTATUS(status) : kOfSignals + WTERMSIG(status);
  return ended_;
}

void Process::signal(int number) const noexcept {
  if (process_ != 0) ::kill(-process_, number);
}

void Process::stop() noexcept {
  if (process_ == 0) return;
  signal(SIGCONT);
  signal(SIGTERM);
  const auto until = std::chrono::steady_clock::now() + kPatience;
  while (!ended() && std::chrono::steady_clock::now() < until) std::this_thread::sleep_for(kPause);
  signal(SIGKILL);
  if (!ended_) ::waitpid(process_, nullptr, 0);
  process_ = 0;
}

std::string Process::last_line() const {
  std::ifstream file{log_};
  std::string line, last;
  while (std::getline(file, line))
    if (!line.empty()) last = line;
  return last;
}

}  // namespace scenario
