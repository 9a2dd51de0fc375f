// wait, waitpid, wait3, wait4, waitid.
#include <cerrno>

#include "can/preload/calls/exported.hpp"
#include "can/preload/calls/failed.hpp"
#include "can/preload/time/base/clock.hpp"
#include "can/preload/time/base/real.hpp"
#include "can/preload/time/wait/children.hpp"
#include "can/preload/time/wait/readiness.hpp"
#include "can/preload/time/wait/wait.hpp"

namespace preload {

namespace {

/// Waits for a child while @p look, a call that does not wait, returns 0; @p block is the same one that does.
template <class Look, class Block>
pid_t await_child(Look look, Block block) noexcept {
  Wait wait{};
  wait.for_children = true;
  for (;;) {
    const pid_t outcome = look();
    if (outcome != 0) return outcome;
    const Ended ended = wait_for(wait);
    if (ended == Ended::Gone) return block();
    if (ended != Ended::Signal) continue;
    if (const pid_t late = look(); late != 0) return late;
    if (!restarts_after_signal()) return failed(EINTR);
  }
}

}  // namespace

}  // namespace preload

using preload::by_turns;
using preload::real;

PRELOAD_EXPORT pid_t wait4(pid_t process, int* status, int options, rusage* usage) noexcept {
  const auto call = [=](int flags) noexcept {
    const pid_t ended = real().wait4(process, status, options | flags, usage);
    if (ended > 0) preload::note_reaped();
    return ended;
  };
  if (!by_turns()) return call(0);
  if ((options & WNOHANG) != 0) {
    const pid_t ended = call(0);
    if (ended == 0) preload::note_idle();
    return ended;
  }
  return preload::await_child([=]() noexcept { return call(WNOHANG); }, [=]() noexcept { return call(0); });
}

PRELOAD_EXPORT pid_t waitpid(pid_t process, int* status, int options) {
  return wait4(process, status, options, nullptr);
}

PRELOAD_EXPORT pid_t wait(int* status) {
  return wait4(-1, status, 0, nullptr);
}

PRELOAD_EXPORT pid_t wait3(int* status, int options, rusage* usage) noexcept {
  return wait4(-1, status, options, usage);
}

PRELOAD_EXPORT int waitid(idtype_t type, id_t identifier, siginfo_t* info, int options) {
  if (!by_turns() || (options & WNOHANG) != 0) return real().waitid(type, identifier, info, options);
  siginfo_t unused{};
  siginfo_t* const found = info != nullptr ? info : &unused;
  const auto look = [=]() noexcept -> pid_t {
    found->si_pid = 0;
    if (real().waitid(type, identifier, found, options | WNOHANG) != 0) return -1;
    if (found->si_pid != 0 && (options & WNOWAIT) == 0) preload::note_reaped();
    return found->si_pid;
  };
  const auto block = [=]() noexcept -> pid_t { return real().waitid(type, identifier, found, options); };
  return preload::await_child(look, block) < 0 ? -1 : 0;
}
