// poll, ppoll, and what a fortified program calls in their place.
#include <cerrno>

#include "can/preload/calls/exported.hpp"
#include "can/preload/calls/failed.hpp"
#include "can/preload/time/base/clock.hpp"
#include "can/preload/time/base/instant.hpp"
#include "can/preload/time/base/real.hpp"
#include "can/preload/time/wait/look.hpp"

namespace preload {

namespace {

constexpr timespec kNoTime{};

/// For @p duration of the bus.
int poll_for(pollfd* descriptors, nfds_t count, int64_t duration, const sigset_t* mask) noexcept {
  Wait wait{};
  wait.descriptors = descriptors;
  wait.count = count;
  wait.deadline = after(present(), duration);
  wait.mask = mask;
  const auto ask = [=](const timespec* limit) { return real().ppoll(descriptors, count, limit, mask); };
  return look_until(
      wait, [=] { return ask(&kNoTime); },
      [=](int64_t deadline) {
        const timespec limit = timespec_of(machine_left(deadline));
        return ask(deadline == kNoInstant ? nullptr : &limit);
      });
}

}  // namespace

}  // namespace preload

using preload::by_machine;
using preload::real;

PRELOAD_EXPORT int poll(pollfd* descriptors, nfds_t count, int milliseconds) {
  if (by_machine()) return real().poll(descriptors, count, milliseconds);
  return preload::poll_for(descriptors, count, preload::ns_of_limit(milliseconds), nullptr);
}

PRELOAD_EXPORT int ppoll(pollfd* descriptors, nfds_t count, const timespec* limit, const sigset_t* mask) {
  if (by_machine()) return real().ppoll(descriptors, count, limit, mask);
  if (limit != nullptr && !preload::is_valid(*limit)) return preload::failed(EINVAL);
  return preload::poll_for(descriptors, count, preload::ns_of_limit(limit), mask);
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
