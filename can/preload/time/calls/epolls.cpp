// epoll_wait, epoll_pwait, epoll_pwait2.
#include <cerrno>

#include "can/preload/calls/exported.hpp"
#include "can/preload/calls/failed.hpp"
#include "can/preload/time/base/clock.hpp"
#include "can/preload/time/base/instant.hpp"
#include "can/preload/time/base/real.hpp"
#include "can/preload/time/wait/look.hpp"

namespace preload {

namespace {

/// A call of epoll_pwait(2) but for its limit of time.
struct Epoll {
  int descriptor;
  epoll_event* events;
  int most;
  const sigset_t* mask;

  [[nodiscard]] int look() const noexcept { return real().epoll_pwait(descriptor, events, most, 0, mask); }
};

int epoll_by_machine(const Epoll& epoll, int64_t deadline) noexcept {
  if (deadline == kNoInstant)
    return real().epoll_pwait(epoll.descriptor, epoll.events, epoll.most, -1, epoll.mask);
  const int64_t duration = machine_left(deadline);
  const int64_t milliseconds = duration / kNsOfMillisecond + (duration % kNsOfMillisecond != 0 ? 1 : 0);
  return real().epoll_pwait(epoll.descriptor, epoll.events, epoll.most,
                            milliseconds < INT32_MAX ? static_cast<int>(milliseconds) : INT32_MAX, epoll.mask);
}

int epoll_for(const Epoll& epoll, int64_t duration) noexcept {
  const pollfd wanted{epoll.descriptor, POLLIN, 0};
  Wait wait{};
  wait.descriptors = &wanted;
  wait.count = 1;
  wait.deadline = after(present(), duration);
  wait.mask = epoll.mask;
  return look_until(
      wait, [&epoll] { return epoll.look(); },
      [&epoll](int64_t deadline) { return epoll_by_machine(epoll, deadline); });
}

}  // namespace

}  // namespace preload

using preload::by_machine;
using preload::real;

PRELOAD_EXPORT int epoll_wait(int descriptor, epoll_event* events, int most, int milliseconds) {
  if (by_machine()) return real().epoll_wait(descriptor, events, most, milliseconds);
  return preload::epoll_for({descriptor, events, most, nullptr}, preload::ns_of_limit(milliseconds));
}

PRELOAD_EXPORT int epoll_pwait(int descriptor, epoll_event* events, int most, int milliseconds,
                               const sigset_t* mask) {
  if (by_machine()) return real().epoll_pwait(descriptor, events, most, milliseconds, mask);
  return preload::epoll_for({descriptor, events, most, mask}, preload::ns_of_limit(milliseconds));
}

PRELOAD_EXPORT int epoll_pwait2(int descriptor, epoll_event* events, int most, const timespec* limit,
                                const sigset_t* mask) {
  if (by_machine()) return real().epoll_pwait2(descriptor, events, most, limit, mask);
  if (limit != nullptr && !preload::is_valid(*limit)) return preload::failed(EINVAL);
  return preload::epoll_for({descriptor, events, most, mask}, preload::ns_of_limit(limit));
}
