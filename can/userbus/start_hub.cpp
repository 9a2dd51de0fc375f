#include "can/userbus/start_hub.hpp"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include <fcntl.h>
#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>

namespace userbus {

namespace {

constexpr size_t kStackSize = size_t{32} * 1024;
constexpr size_t kStackAlignment = 16;
constexpr int kCannotExecute = 127;
constexpr int kKilled = 126;

/// What the processes between the caller and the hub need; they share the caller's memory.
struct Start {
  char* const* words;
  char** environment;
  int error;                                            ///< errno of execve
  alignas(kStackAlignment) char middle[kStackSize];     ///< stack of the process that waits
  alignas(kStackAlignment) char innermost[kStackSize];  ///< stack of the process that becomes the hub
};

/// The end of a stack, which grows downwards.
void* top_of(char (&stack)[kStackSize]) noexcept {
  return stack + kStackSize;
}

void reset_signals() noexcept {
  struct sigaction action {};
  action.sa_handler = SIG_DFL;
  for (int number = 1; number < NSIG; ++number) sigaction(number, &action, nullptr);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
}

void leave_descriptors() noexcept {
  const int null = open("/dev/null", O_RDWR);
  for (int standard = 0; standard < 3; ++standard) dup2(null, standard);
  constexpr unsigned kFirst = 3;
  if (close_range(kFirst, ~0U, 0) == 0) return;
  for (int other = static_cast<int>(kFirst); other < sysconf(_SC_OPEN_MAX); ++other) close(other);
}

// The address sanitizer knows the stacks of threads only, and would complain about those of these two.

[[gnu::no_sanitize_address]] int become_hub(void* argument) noexcept {
  auto& start = *static_cast<Start*>(argument);
  setsid();
  leave_descriptors();
  reset_signals();
  execve(start.words[0], start.words, start.environment);
  start.error = errno;
  _exit(kCannotExecute);
}

/// A process that is executed tells its parent by SIGCHLD when it ends. The caller may have a handler for that, so
/// this process, which is not executed and tells nobody, is the parent.
[[gnu::no_sanitize_address]] int wait_for_hub(void* argument) noexcept {
  auto& start = *static_cast<Start*>(argument);
  const int hub = clone(become_hub, top_of(start.innermost), CLONE_VM | CLONE_VFORK | SIGCHLD, argument);
  int status = 0;
  if (hub < 0 || waitpid(hub, &status, 0) != hub) _exit(static_cast<int>(StartStatus::Failed));
  _exit(WIFEXITED(status) ? WEXITSTATUS(status) : kKilled);
}

/// Copies the environment, except what would make the hub load the preload library, to @p copy.
void copy_environment(char** copy) noexcept {
  constexpr char kPreload[] = "LD_PRELOAD=";
  for (char** entry = environ; *entry != nullptr; ++entry)
    if (strncmp(*entry, kPreload, sizeof kPreload - 1) != 0) *copy++ = *entry;
  *copy = nullptr;
}

size_t count_environment() noexcept {
  size_t count = 0;
  while (environ[count] != nullptr) ++count;
  return count;
}

StartStatus run(Start& start) noexcept {
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);  // no handler of the caller may run in its children
  const int middle = clone(wait_for_hub, top_of(start.middle), CLONE_VM | CLONE_VFORK, &start);
  int status = 0;
  const bool ended =
      middle >= 0 && waitpid(middle, &status, static_cast<int>(__WCLONE)) == middle && WIFEXITED(status);
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  if (!ended) return StartStatus::Failed;
  if (WEXITSTATUS(status) == kCannotExecute) {
    errno = start.error;
    return StartStatus::Failed;
  }
  if (WEXITSTATUS(status) == kKilled) {
    errno = EINTR;
    return StartStatus::Failed;
  }
  errno = EIO;
  return static_cast<StartStatus>(WEXITSTATUS(status));
}

}  // namespace

StartStatus start_hub(const char* hub, const char* path, const char* bit_rate, const char* time) noexcept {
  const char* words[9] = {hub, "--on-demand", "--path", path};
  size_t count = 4;
  if (bit_rate != nullptr) {
    words[count++] = "--bitrate";
    words[count++] = bit_rate;
  }
  if (time != nullptr) {
    words[count++] = "--time";
    words[count++] = time;
  }
  auto* const start = static_cast<Start*>(malloc(sizeof(Start) + (count_environment() + 1) * sizeof(char*)));
  if (start == nullptr) return StartStatus::Failed;
  start->words = const_cast<char* const*>(words);
  start->environment = reinterpret_cast<char**>(start + 1);
  start->error = 0;
  copy_environment(start->environment);
  const StartStatus status = run(*start);
  const int error = errno;
  free(start);
  errno = error;
  return status;
}

}  // namespace userbus
