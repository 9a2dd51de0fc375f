// exec…, _exit: a process becomes another program, or ends.
#include <cerrno>
#include <cstdarg>
#include <cstring>

#include "can/preload/calls/exported.hpp"
#include "can/preload/time/base/clock.hpp"
#include "can/preload/time/base/real.hpp"
#include "can/preload/time/process/child.hpp"
#include "can/preload/time/process/environment.hpp"
#include "can/preload/time/turn/turn.hpp"

namespace preload {

namespace {

/// Runs @p execute with the environment that @p given becomes; it returns only if it fails.
template <class Execute>
int become(char* const* given, Execute execute) noexcept {
  const ProgramEnvironment environment{given};
  const bool prepared = prepare_exec();
  const int outcome = execute(environment.entries());
  if (prepared) resume_after_exec();
  return outcome;
}

/// Words of execl(3) and its kind at most, those of a command line that somebody wrote.
constexpr size_t kMostWords = 4096;

/// The words that follow @p first up to a null pointer; false if they are too many.
bool read_words(const char* first, va_list& arguments, char* (&words)[kMostWords]) noexcept {
  words[0] = const_cast<char*>(first);
  for (size_t i = 0; words[i] != nullptr; words[i] = va_arg(arguments, char*))
    if (++i == kMostWords) {
      errno = E2BIG;
      return false;
    }
  return true;
}

}  // namespace

}  // namespace preload

using preload::become;
using preload::real;

PRELOAD_EXPORT int execve(const char* path, char* const* words, char* const* environment) noexcept {
  return become(environment, [=](char* const* own) noexcept { return real().execve(path, words, own); });
}

PRELOAD_EXPORT int execv(const char* path, char* const* words) noexcept {
  return execve(path, words, environ);
}

PRELOAD_EXPORT int execvpe(const char* file, char* const* words, char* const* environment) noexcept {
  return become(environment, [=](char* const* own) noexcept { return real().execvpe(file, words, own); });
}

PRELOAD_EXPORT int execvp(const char* file, char* const* words) noexcept {
  return execvpe(file, words, environ);
}

PRELOAD_EXPORT int fexecve(int file, char* const* words, char* const* environment) noexcept {
  return become(environment, [=](char* const* own) noexcept { return real().fexecve(file, words, own); });
}

PRELOAD_EXPORT int execveat(int folder, const char* path, char* const* words, char* const* environment,
                            int flags) noexcept {
  return become(environment,
                [=](char* const* own) noexcept { return real().execveat(folder, path, words, own, flags); });
}

PRELOAD_EXPORT int execl(const char* path, const char* first, ...) noexcept {
  char* words[preload::kMostWords];
  va_list arguments;
  va_start(arguments, first);
  const bool read = preload::read_words(first, arguments, words);
  va_end(arguments);
  return read ? execv(path, words) : -1;
}

PRELOAD_EXPORT int execlp(const char* file, const char* first, ...) noexcept {
  char* words[preload::kMostWords];
  va_list arguments;
  va_start(arguments, first);
  const bool read = preload::read_words(first, arguments, words);
  va_end(arguments);
  return read ? execvp(file, words) : -1;
}

PRELOAD_EXPORT int execle(const char* path, const char* first, ...) noexcept {
  char* words[preload::kMostWords];
  va_list arguments;
  va_start(arguments, first);
  const bool read = preload::read_words(first, arguments, words);
  char* const* const environment = read ? va_arg(arguments, char* const*) : nullptr;
  va_end(arguments);
  return read ? execve(path, words, environment) : -1;
}

PRELOAD_EXPORT void _exit(int status) {
  preload::tell_present();
  real().exit_at_once(status);
  __builtin_unreachable();
}

PRELOAD_EXPORT void _Exit(int status) noexcept {
  _exit(status);
}
