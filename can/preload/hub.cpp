#include "can/preload/hub.hpp"

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <dlfcn.h>
#include <pthread.h>

#include "can/preload/next.hpp"

namespace preload {

namespace {

/// Keeps the thread from being cancelled, which would leave descriptors open.
class NotCancelled {
 public:
  NotCancelled() noexcept { pthread_setcancelstate(PTHREAD_CANCEL_DISABLE, &before_); }
  NotCancelled(const NotCancelled&) = delete;
  NotCancelled& operator=(const NotCancelled&) = delete;
  ~NotCancelled() { pthread_setcancelstate(before_, nullptr); }

 private:
  int before_ = PTHREAD_CANCEL_ENABLE;
};

/// Where the bus of this process is at present; a program may change $CAN_BUS between its sockets.
struct BusPlace {
  bool fits;  ///< the path of the bus is not too long
  userbus::Path bus;
};

/// The program that serves it.
char hub_program[4096];
pthread_once_t hub_is_known = PTHREAD_ONCE_INIT;

/// canhub, as it lies beside this library in the build folder and where it is installed.
void find_hub() noexcept {
  if (const char* const chosen = getenv("CAN_HUB"); chosen != nullptr && *chosen != '\0') {
    snprintf(hub_program, sizeof hub_program, "%s", chosen);
    return;
  }
  Dl_info library{};
  if (dladdr(hub_program, &library) == 0 || library.dli_fname == nullptr) return;
  const char* const slash = strrchr(library.dli_fname, '/');
  const int folder = slash == nullptr ? 0 : static_cast<int>(slash - library.dli_fname + 1);
  snprintf(hub_program, sizeof hub_program, "%.*s../../bin/canhub", folder, library.dli_fname);
}

BusPlace present_place() noexcept {
  BusPlace place{};
  place.fits = userbus::default_path(place.bus);
  return place;
}

/// Says once in a process why there is no bus.
void report(const BusPlace& at, const char* reason) noexcept {
  static std::atomic<bool> reported;
  if (reported.exchange(true)) return;
  char line[512];
  const int length = snprintf(line, sizeof line, "libcan-preload: the CAN bus %s %s\n", at.bus.text, reason);
  const size_t size = static_cast<size_t>(length) < sizeof line ? static_cast<size_t>(length) : sizeof line - 1;
  if (next().write(STDERR_FILENO, line, size) < 0) return;
}

int errno_of(userbus::JoinError error) noexcept {
  switch (error) {
    case userbus::JoinError::System:
      return errno;
    case userbus::JoinError::Denied:
    case userbus::JoinError::Folder:
      return EACCES;
    case userbus::JoinError::None:
    case userbus::JoinError::InUse:
    case userbus::JoinError::NoHub:
    case userbus::JoinError::BitRate:
    case userbus::JoinError::Time:
    case userbus::JoinError::Different:
    case userbus::JoinError::NotServed:
      return EAFNOSUPPORT;  // as on a kernel without CAN
  }
  return EAFNOSUPPORT;
}

}  // namespace

int join_bus(userbus::Kind kind, int flags) noexcept {
  const NotCancelled not_cancelled;
  const BusPlace at = present_place();
  if (!at.fits) {
    report(at, "has a path that is too long: 107 bytes are the most");
    errno = EAFNOSUPPORT;
    return -1;
  }
  pthread_once(&hub_is_known, find_hub);
  const userbus::Joined joined = userbus::join(at.bus, hub_program, kind, flags);
  if (joined.descriptor >= 0) return joined.descriptor;
  const int error = errno_of(joined.error);
  report(at, userbus::text_of(joined.error));
  errno = error;
  return -1;
}

int join_served_bus() noexcept {
  const NotCancelled not_cancelled;
  const BusPlace at = present_place();
  if (!at.fits) return -1;
  return userbus::join(at.bus, nullptr, userbus::Kind::Raw, SOCK_CLOEXEC).descriptor;
}

int join_time(int process) noexcept {
  const NotCancelled not_cancelled;
  const BusPlace at = present_place();
  if (!at.fits) {
    report(at, "has a path that is too long: 107 bytes are the most");
    return -1;
  }
  pthread_once(&hub_is_known, find_hub);
  const userbus::JoinedClock joined = userbus::join_clock(at.bus, hub_program, 0, process, process == 0);
  if (joined.descriptor < 0) report(at, userbus::text_of(joined.error));
  return joined.descriptor;
}

void report_bus(const char* reason) noexcept {
  report(present_place(), reason);
}

int tell(int descriptor, userbus::Operation operation, int value, const void* payload, size_t size) noexcept {
  const NotCancelled not_cancelled;
  const userbus::Answer answer = userbus::ask(descriptor, operation, value, payload, size, nullptr, 0);
  if (answer.error == 0) return 0;
  errno = answer.error;
  return -1;
}

userbus::Answer ask(int descriptor, userbus::Operation operation, int value, void* reply, size_t room) noexcept {
  const NotCancelled not_cancelled;
  return userbus::ask(descriptor, operation, value, nullptr, 0, reply, room);
}

userbus::Answer ask_for_descriptor(int descriptor, userbus::Operation operation, int& passed) noexcept {
  const NotCancelled not_cancelled;
  return userbus::ask(descriptor, operation, 0, nullptr, 0, nullptr, 0, &passed);
}

userbus::Answer ask_about(int descriptor, userbus::Operation operation, const char* text, size_t size) noexcept {
  const NotCancelled not_cancelled;
  return userbus::ask(descriptor, operation, 0, text, size, nullptr, 0);
}

}  // namespace preload
