#include "farm/agent/process/program_start.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string_view>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "os/own_program.hpp"

namespace farm::agent {
namespace {

constexpr std::array<std::string_view, 6> kOwnVariables{"NOTIFY_SOCKET", "WATCHDOG_PID", "WATCHDOG_USEC",
                                                        "LISTEN_FDS",    "LISTEN_PID",   "LD_PRELOAD"};

/// What a session with nothing of this process is made of, for posix_spawn(3).
class Conditions {
 public:
  explicit Conditions(const ProgramStart& start) noexcept {
    posix_spawn_file_actions_init(&actions);
    if (start.output >= 0) note(posix_spawn_file_actions_adddup2(&actions, start.output, STDERR_FILENO));
    const int first_closed = start.kept >= 0 ? STDERR_FILENO + 2 : STDERR_FILENO + 1;
    if (start.kept >= 0) note(posix_spawn_file_actions_adddup2(&actions, start.kept, STDERR_FILENO + 1));
    for (const int standard : {STDIN_FILENO, STDOUT_FILENO})
      note(posix_spawn_file_actions_addopen(&actions, standard, "/dev/null", O_RDWR, 0));
    note(posix_spawn_file_actions_addclosefrom_np(&actions, first_closed));
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSID | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
    sigset_t signals;
    sigfillset(&signals);
    posix_spawnattr_setsigdefault(&attributes, &signals);
    sigemptyset(&signals);
    posix_spawnattr_setsigmask(&attributes, &signals);
  }
  Conditions(const Conditions&) = delete;
  Conditions& operator=(const Conditions&) = delete;
  ~Conditions() {
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
  }

  posix_spawn_file_actions_t actions{};
  posix_spawnattr_t attributes{};
  int error = 0;  ///< 0: all of it was noted

 private:
  void note(int result) noexcept {
    if (error == 0) error = result;
  }
};

std::string_view name_of(std::string_view variable) noexcept {
  return variable.substr(0, variable.find('='));
}

/// The environment that the program is to have.
std::vector<std::string> variables_of(const ProgramStart& start) {
  std::vector<std::string> variables = start.variables;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const auto is_same = [&](const std::string& other) { return name_of(other) == name_of(*entry); };
    const bool is_own = std::ranges::find(kOwnVariables, name_of(*entry)) != kOwnVariables.end();
    if (!is_own && std::ranges::none_of(start.variables, is_same)) variables.emplace_back(*entry);
  }
  return variables;
}

/// @p texts as the kernel wants them, ended by a null pointer.
std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  pointers.reserve(texts.size() + 1);
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// Nobody would look after it.
void end_child(pid_t number) noexcept {
  ::kill(number, SIGKILL);
  ::waitpid(number, nullptr, 0);
}

}  // namespace

tl::expected<ProcessHandle, std::string> start_program(const ProgramStart& start) {
  const Conditions conditions{start};
  std::vector<std::string> texts = variables_of(start);
  std::vector<std::string> arguments = start.words;
  const std::vector<char*> variables = pointers_to(texts);
  const std::vector<char*> words = pointers_to(arguments);
  pid_t number = 0;
  int error = conditions.error;
  if (error == 0)
    error = posix_spawn(&number, words.front(), &conditions.actions, &conditions.attributes, words.data(),
                        variables.data());
  if (error != 0)
    return tl::unexpected{fmt::format("{}: cannot be started: {}", start.words.front(), std::strerror(error))};
  auto process = find_process(number);
  if (!process) end_child(number);
  return process;
}

tl::expected<ProcessHandle, std::string> find_process(pid_t number) {
  os::Descriptor descriptor{static_cast<int>(::syscall(SYS_pidfd_open, number, 0))};
  if (!descriptor) return tl::unexpected{fmt::format("process {}: {}", number, std::strerror(errno))};
  return ProcessHandle{number, std::move(descriptor)};
}

std::string program_beside(const std::string& name) {
  return (os::program_folder() / name).string();
}

}  // namespace farm::agent
