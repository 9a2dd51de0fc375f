// poll, ppoll, and what a fortified program calls in their place.
#include <cerrno>

#include "can/preload/calls/exported.hpp"
#include "can/preload/calls/failed.hpp"
#include "can/preload/time/base/clock.hpp"
#include "can/preload/time/base/instant.hpp"
#include "can/preload/time/base/real.hpp"
#include "can/preload/time/wait/wait.hpp"

namespace preload {

namespace {

constexpr timespec kNoTime{};

/// Until the machine's clock shows what the bus's shows as @p deadline.
int poll_by_machine(pollfd* descriptors, nfds_t count, int64_t deadline, const sigset_t* mask) noexcept {
  const int64_t now = present();
  const timespec limit = timespec_of(machine_duration(deadline > now ? deadline - now : 0));
  return real().ppoll(descriptors, count, deadline == kNoInstant ? nullptr : &limit, mask);
}

int poll_until(pollfd* descriptors, nfds_t count, int64_t deadline, const sigset_t* mask) noexcept {
  Wait wait{};
  wait.descriptors = descriptors;
  wait.count = count;
  wait.deadline = deadline;
  wait.mask = mask;
  wait.polled = true;
  for (;;) {
    const int ready = real().ppoll(descriptors, count, &kNoTime, mask);
    if (ready != 0) return ready;
    switch (wait_for(wait)) {
      case Ended::Ready:
        break;
      case Ended::Deadline:
        return 0;
      case Ended::Signal:
        return failed(EINTR);
      case Ended::Gone:
        return poll_by_machine(descriptors, count, deadline, mask);
    }
  }
}

/// For @p duration of the bus.
int poll_for(pollfd* descriptors, nfds_t count, int64_t duration, const sigset_t* mask) noexcept {
  const int64_t deadline = after(present(), duration);
  if (!by_turns()) return poll_by_machine(descriptors, count, deadline, mask);
  if (duration != 0) return poll_until(descriptors, count, deadline, mask);
  const int ready = real().ppoll(descriptors, count, &kNoTime, mask);
  if (ready == 0) note_idle();
  return ready;
}

}  // namespace

}  // namespace preload

using preload::by_machine;
using preload::real;

PRELOAD_EXPORT int poll(pollfd* descriptors, nfds_t count, int milliseconds) {
  if (by_machine()) return real().poll(descriptors, count, milliseconds);
  const int64_t duration = milliseconds < 0 ? preload::kNoInstant : milliseconds * preload::kNsOfMillisecond;
  return preload::poll_for(descriptors, count, duration, nullptr);
}

PRELOAD_EXPORT int ppoll(pollfd* descriptors, nfds_t count, const timespec* limit, const sigset_t* mask) {
  if (by_machine()) return real().ppoll(descriptors, count, limit, mask);
  if (limit != nullptr && !preload::is_valid(*limit)) return preload::failed(EINVAL);
  const int64_t duration = limit == nullptr ? preload::kNoInstant : preload::ns_of(*limit);
  return preload::poll_for(descriptors, count, duration, mask);
}

// The C library's own check ends the program if `room` is too small.

PRELOAD_EXPORT int __poll_chk(pollfd* descriptors, nfds_t count, int milliseconds, size_t room) {
  if (room / sizeof(pollfd) < count) abort();
  return poll(descriptors, count, milliseconds);
}

PRELOAD_EXPORT int __ppoll_chk(pollfd* descriptors, nfds_t count, const timespec* limit, const sigset_t* mask,
                               size_t room) {
  if (room / sizeof(pollfd) < count) abort();
  return ppoll(descriptors, count, limit, mask);
}
