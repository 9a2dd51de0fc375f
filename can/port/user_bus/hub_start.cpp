#include "can/port/user_bus/hub_start.hpp"

#include <cerrno>
#include <cstring>
#include <exception>
#include <string>
#include <vector>

#include <fcntl.h>
#include <spawn.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace bus {

namespace {

using userbus::JoinError;
using userbus::StartStatus;

/// What a new session with nothing of this process is made of, for posix_spawn(3).
class Conditions {
 public:
  Conditions() noexcept {
    posix_spawn_file_actions_init(&actions);
    for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
      posix_spawn_file_actions_addopen(&actions, standard, "/dev/null", O_RDWR, 0);
    posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
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
};

/// The environment, except what would make the hub load the preload library.
std::vector<char*> environment() {
  constexpr char kPreload[] = "LD_PRELOAD=";
  std::vector<char*> copy;
  for (char** entry = environ; *entry != nullptr; ++entry)
    if (std::strncmp(*entry, kPreload, sizeof kPreload - 1) != 0) copy.push_back(*entry);
  copy.push_back(nullptr);
  return copy;
}

/// Starts the program that @p words begin with as the child @p process; 0 or the error.
int spawn(std::vector<std::string> words, pid_t& process) {
  const Conditions conditions;
  std::vector<char*> variables = environment();
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  return posix_spawn(&process, arguments.front(), &conditions.actions, &conditions.attributes, arguments.data(),
                     variables.data());
}

/// The command line of a hub that serves @p path.
std::vector<std::string> words_of(const std::string& hub, const char* path, const userbus::HubWishes& wishes) {
  std::vector<std::string> words{hub, "--on-demand", "--path", path};
  if (wishes.bit_rate != nullptr) words.insert(words.end(), {"--bitrate", wishes.bit_rate});
  if (wishes.time != nullptr) words.insert(words.end(), {"--time", wishes.time});
  return words;
}

}  // namespace

JoinError HubStart::begin(const std::string& hub, const userbus::Path& path) noexcept {
  userbus::HubWishes wishes{};
  if (const JoinError wrong = userbus::wanted_hub(wishes); wrong != JoinError::None) return wrong;
  pid_t process = 0;
  int error = 0;
  try {
    error = spawn(words_of(hub, path.text, wishes), process);
  } catch (const std::exception&) {
    error = ENOMEM;
  }
  if (error != 0) return userbus::error_of(StartStatus::Failed, error);
  process_ = os::Descriptor{static_cast<int>(syscall(SYS_pidfd_open, process, 0))};
  return process_ ? JoinError::None : JoinError::System;
}

std::optional<JoinError> HubStart::finish() noexcept {
  siginfo_t end{};
  if (waitid(P_PIDFD, static_cast<id_t>(process_.get()), &end, WEXITED | WNOHANG) == 0 && end.si_pid == 0)
    return std::nullopt;
  process_ = os::Descriptor{};
  // ended by somebody, or waited for by somebody else: whether the path is served is seen by joining
  if (end.si_code != CLD_EXITED) return JoinError::None;
  return userbus::error_of(static_cast<StartStatus>(end.si_status), 0);
}

}  // namespace bus
