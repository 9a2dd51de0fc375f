#include "os/missing_memory.hpp"

#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>

#include <sys/uio.h>
#include <unistd.h>

namespace os {
namespace {

/// What the handler needs: it cannot be given anything.
struct Ending {
  const char* program = "";
  int status = EXIT_FAILURE;
  std::terminate_handler before = std::abort;
};
Ending ending;

void say_and_end() noexcept {
  constexpr const char* kSaid = ": there is no memory left\n";
  const iovec line[] = {{const_cast<char*>(ending.program), std::strlen(ending.program)},
                        {const_cast<char*>(kSaid), std::strlen(kSaid)}};
  static_cast<void>(!::writev(STDERR_FILENO, line, 2));
  ::_exit(ending.status);
}

[[noreturn]] void on_terminate() noexcept {
  try {
    if (const std::exception_ptr thrown = std::current_exception()) std::rethrow_exception(thrown);
  } catch (const std::bad_alloc&) {
    say_and_end();
  } catch (...) {  // it is said below
  }
  ending.before();
  std::abort();
}

}  // namespace

void end_if_memory_is_missing(const char* program, int status) noexcept {
  ending = {program, status, std::set_terminate(on_terminate)};
}

}  // namespace os
