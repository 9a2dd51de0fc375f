// vfork, posix_spawn, posix_spawnp, system, popen, pclose; fork(2) itself tells the library (process/child).
#include <cerrno>
#include <cstring>

#include <fcntl.h>

#include "can/preload/calls/exported.hpp"
#include "can/preload/time/base/clock.hpp"
#include "can/preload/time/base/real.hpp"
#include "can/preload/time/process/child.hpp"
#include "can/preload/time/process/environment.hpp"
#include "can/preload/time/turn/touch.hpp"

namespace preload {

namespace {

constexpr char kShell[] = "/bin/sh";

/// Starts `sh -c COMMAND` as @p attributes and @p actions say; -1 with errno.
pid_t start_shell(const char* command, const posix_spawn_file_actions_t* actions,
                  const posix_spawnattr_t* attributes) noexcept {
  char* const words[] = {const_cast<char*>("sh"), const_cast<char*>("-c"), const_cast<char*>(command), nullptr};
  pid_t process = -1;
  const int error = posix_spawn(&process, kShell, actions, attributes, words, environ);
  if (error == 0) return process;
  errno = error;
  return -1;
}

int await_shell(pid_t process) noexcept {
  int status = -1;
  pid_t ended = -1;
  do ended = wait4(process, &status, 0, nullptr);
  while (ended < 0 && errno == EINTR);
  return ended == process ? status : -1;
}

/// What system(3) does to signals meanwhile.
class SignalsOfSystem {
 public:
  SignalsOfSystem() noexcept {
    struct sigaction ignored {};
    ignored.sa_handler = SIG_IGN;
    sigaction(SIGINT, &ignored, &interrupt_);
    sigaction(SIGQUIT, &ignored, &quit_);
    sigset_t child;
    sigemptyset(&child);
    sigaddset(&child, SIGCHLD);
    pthread_sigmask(SIG_BLOCK, &child, &mask_);
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setsigmask(&attributes_, &mask_);
    sigset_t standard;
    sigemptyset(&standard);
    if (interrupt_.sa_handler != SIG_IGN) sigaddset(&standard, SIGINT);
    if (quit_.sa_handler != SIG_IGN) sigaddset(&standard, SIGQUIT);
    posix_spawnattr_setsigdefault(&attributes_, &standard);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
  }
  SignalsOfSystem(const SignalsOfSystem&) = delete;
  SignalsOfSystem& operator=(const SignalsOfSystem&) = delete;
  ~SignalsOfSystem() {
    posix_spawnattr_destroy(&attributes_);
    sigaction(SIGINT, &interrupt_, nullptr);
    sigaction(SIGQUIT, &quit_, nullptr);
    pthread_sigmask(SIG_SETMASK, &mask_, nullptr);
  }

  [[nodiscard]] const posix_spawnattr_t* attributes() const noexcept { return &attributes_; }

 private:
  struct sigaction interrupt_ {};
  struct sigaction quit_ {};
  sigset_t mask_{};
  posix_spawnattr_t attributes_{};
};

/// A stream of popen(3).
struct ShellStream {
  FILE* stream;
  pid_t process;
};
constexpr int kMostStreams = 32;
ShellStream shell_streams[kMostStreams];

ShellStream* stream_of(const FILE* stream) noexcept {
  for (ShellStream& one : shell_streams)
    if (one.stream == stream) return &one;
  return nullptr;
}

FILE* open_shell(const char* command, bool reads, bool closed_on_exec) noexcept {
  ShellStream* const place = stream_of(nullptr);
  int ends[2];
  if (place == nullptr || pipe2(ends, O_CLOEXEC) != 0) return nullptr;
  const int own = reads ? ends[0] : ends[1];
  const int other = reads ? ends[1] : ends[0];
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, other, reads ? STDOUT_FILENO : STDIN_FILENO);
  const pid_t process = start_shell(command, &actions, nullptr);
  posix_spawn_file_actions_destroy(&actions);
  close(other);
  FILE* const stream = process < 0 ? nullptr : fdopen(own, reads ? "r" : "w");
  if (stream == nullptr) {
    close(own);
    return nullptr;
  }
  if (!closed_on_exec) fcntl(own, F_SETFD, 0);
  *place = {stream, process};
  return stream;
}

}  // namespace

}  // namespace preload

using preload::by_turns;
using preload::real;

/// The child of vfork(2) has the parent's memory, where this library could not tell it from the parent.
PRELOAD_EXPORT pid_t vfork() noexcept {
  return by_turns() ? fork() : real().vfork();
}

PRELOAD_EXPORT int posix_spawn(pid_t* process, const char* path, const posix_spawn_file_actions_t* actions,
                               const posix_spawnattr_t* attributes, char* const* words, char* const* environment) {
  const preload::ProgramEnvironment own{environment};
  const int socket = preload::prepare_child();
  const int error = real().posix_spawn(process, path, actions, attributes, words, own.entries());
  preload::leave_to_child(socket);
  return error;
}

PRELOAD_EXPORT int posix_spawnp(pid_t* process, const char* file, const posix_spawn_file_actions_t* actions,
                                const posix_spawnattr_t* attributes, char* const* words,
                                char* const* environment) {
  const preload::ProgramEnvironment own{environment};
  const int socket = preload::prepare_child();
  const int error = real().posix_spawnp(process, file, actions, attributes, words, own.entries());
  preload::leave_to_child(socket);
  return error;
}

PRELOAD_EXPORT int system(const char* command) {
  if (!by_turns() || command == nullptr) return real().system(command);
  const preload::SignalsOfSystem signals;
  const pid_t process = preload::start_shell(command, nullptr, signals.attributes());
  return process < 0 ? -1 : preload::await_shell(process);
}

PRELOAD_EXPORT FILE* popen(const char* command, const char* mode) {
  if (!by_turns()) return real().popen(command, mode);
  return preload::open_shell(command, strchr(mode, 'r') != nullptr, strchr(mode, 'e') != nullptr);
}

PRELOAD_EXPORT int pclose(FILE* stream) {
  preload::ShellStream* const known = stream == nullptr ? nullptr : preload::stream_of(stream);
  if (known == nullptr) return real().pclose(stream);
  const pid_t process = known->process;
  known->stream = nullptr;
  preload::note_closing(fileno(stream));
  fclose(stream);
  return preload::await_shell(process);
}
