#include "os/missing_memory.hpp"

#include <cstdlib>
#include <cstring>
#include <exception>
#include <iterator>
#include <new>
#include <system_error>

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
// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): a handler has no other place
Ending ending;

iovec part(const char* text) noexcept {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast): an iovec is for both directions
  return {const_cast<char*>(text), std::strlen(text)};
}

void say_and_end(const char* why) noexcept {
  const iovec line[] = {part(ending.program), part(": "), part(why), part("\n")};
  static_cast<void>(!::writev(STDERR_FILENO, line, std::size(line)));
  ::_exit(ending.status);
}

[[noreturn]] void on_terminate() noexcept {
  try {
    if (const std::exception_ptr thrown = std::current_exception()) std::rethrow_exception(thrown);
  } catch (const std::bad_alloc&) {
    say_and_end("there is no memory left");
  } catch (const std::system_error& refused) {
    say_and_end(refused.what());
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
