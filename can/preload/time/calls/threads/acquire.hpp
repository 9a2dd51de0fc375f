#pragma once

#include <cerrno>

#include "can/preload/time/base/instant.hpp"
#include "can/preload/time/wait/wait.hpp"

namespace preload {

/// What a call that waits for a lock came to where it was not waited by turns.
inline constexpr int kNotByTurns = -1;

/// Something that threads wait for by trying: a try that fails returns EBUSY.
template <class Try>
struct Attempts {
  Try try_once;
  int error;

  static bool is_done(void* attempts) noexcept {
    auto& self = *static_cast<Attempts*>(attempts);
    self.error = self.try_once();
    return self.error != EBUSY;
  }
};

/// Tries until it does not fail with EBUSY, as @p wait, which has the address of what is tried, lets it. ETIMEDOUT
/// at its deadline, EINTR after a signal if @p stops_for_signals, kNotByTurns.
template <class Try>
int acquire(const Wait& wait, bool stops_for_signals, Try try_once) noexcept {
  Attempts<Try> attempts{try_once, try_once()};
  while (attempts.error == EBUSY) {
    const Ended ended = wait_unless(wait, Attempts<Try>::is_done, &attempts);
    if (ended == Ended::Gone) return kNotByTurns;
    if (ended == Ended::Signal && stops_for_signals) return EINTR;
    if (attempts.error == EBUSY) attempts.error = try_once();
    if (ended == Ended::Deadline && attempts.error == EBUSY) return ETIMEDOUT;
  }
  return attempts.error;
}

}  // namespace preload
