#include "tests/fakes/flush_hook.hpp"

#include <cerrno>
#include <utility>

#include <sys/syscall.h>
#include <unistd.h>

namespace {

std::function<int(int)>& hook() {
  static std::function<int(int)> present;
  return present;
}

}  // namespace

/// Takes the place of the one in the C library.
extern "C" int fsync(int descriptor) {
  if (!hook()) return static_cast<int>(::syscall(SYS_fsync, descriptor));
  errno = hook()(descriptor);
  return errno == 0 ? 0 : -1;
}

namespace fakes {

FlushHook::FlushHook(std::function<int(int)> flush) {
  hook() = std::move(flush);
}

FlushHook::~FlushHook() {
  hook() = nullptr;
}

}  // namespace fakes
