// accept, accept4, pipe; close_range, closefrom, dup2, dup3, which leave alone what is this library's.
#include "can/preload/time/wait/descriptors.hpp"

#include <cerrno>

#include "can/preload/calls/exported.hpp"
#include "can/preload/calls/failed.hpp"
#include "can/preload/time/base/clock.hpp"
#include "can/preload/time/base/hidden.hpp"
#include "can/preload/time/base/real.hpp"
#include "can/preload/time/turn/touch.hpp"
#include "can/preload/time/turn/turn.hpp"
#include "can/preload/time/wait/readiness.hpp"
#include "can/preload/time/wait/timer.hpp"

namespace preload {

namespace {

/// Descriptors from @p first to @p last are closed, or are others from now on.
void forget_range(unsigned first, unsigned last) noexcept {
  constexpr unsigned kMost = 1024;
  for (unsigned descriptor = first; descriptor <= last && descriptor < kMost; ++descriptor) {
    forget_descriptor(static_cast<int>(descriptor));
    forget_timer(static_cast<int>(descriptor));
  }
}

/// @p descriptor is about to be another one.
void replace(int descriptor) noexcept {
  note_closing(descriptor);
  forget_descriptor(descriptor);
  forget_timer(descriptor);
}

/// The part of a range from @p first on that has none of the library's own; its end is @p last at most.
unsigned end_of_part(unsigned first, unsigned last) noexcept {
  constexpr unsigned kMost = 4096;
  for (unsigned descriptor = first; descriptor < last && descriptor < kMost; ++descriptor)
    if (is_hidden(static_cast<int>(descriptor + 1))) return descriptor;
  return last;
}

int close_around(unsigned first, unsigned last, int flags) noexcept {
  while (first <= last) {
    if (is_hidden(static_cast<int>(first))) {
      ++first;
      continue;
    }
    const unsigned end = end_of_part(first, last);
    if (real().close_range(first, end, flags) != 0) return -1;
    if (end == last) break;
    first = end + 1;
  }
  return 0;
}

}  // namespace

}  // namespace preload

using preload::by_turns;
using preload::failed;
using preload::real;

PRELOAD_EXPORT int accept(int descriptor, sockaddr* address, socklen_t* length) {
  if (!preload::may_read(descriptor)) return -1;
  return real().accept(descriptor, address, length);
}

PRELOAD_EXPORT int accept4(int descriptor, sockaddr* address, socklen_t* length, int flags) {
  if (!preload::may_read(descriptor)) return -1;
  return real().accept4(descriptor, address, length, flags);
}

PRELOAD_EXPORT int close_range(unsigned first, unsigned last, int flags) noexcept {
  if (!by_turns()) return real().close_range(first, last, flags);
  constexpr unsigned kClosedLater = 4;  // CLOSE_RANGE_CLOEXEC
  if ((static_cast<unsigned>(flags) & kClosedLater) == 0) {
    preload::note_touched();
    preload::forget_range(first, last);
  }
  return preload::close_around(first, last, flags);
}

PRELOAD_EXPORT void closefrom(int first) noexcept {
  if (!by_turns()) return real().closefrom(first);
  close_range(first < 0 ? 0 : static_cast<unsigned>(first), ~0U, 0);
}

PRELOAD_EXPORT int dup2(int from, int to) noexcept {
  if (preload::is_hidden(to) || preload::is_hidden(from)) return failed(EBADF);
  if (by_turns() && from != to) preload::replace(to);
  return real().dup2(from, to);
}

PRELOAD_EXPORT int dup3(int from, int to, int flags) noexcept {
  if (preload::is_hidden(to) || preload::is_hidden(from)) return failed(EBADF);
  if (by_turns()) preload::replace(to);
  return real().dup3(from, to, flags);
}
