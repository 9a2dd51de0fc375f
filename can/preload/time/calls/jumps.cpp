// longjmp, siglongjmp: a signal handler may jump out of a call that waits.
#include "can/preload/calls/exported.hpp"
#include "can/preload/time/base/clock.hpp"
#include "can/preload/time/base/real.hpp"
#include "can/preload/time/wait/scheduler.hpp"

namespace preload {

namespace {

[[noreturn]] void jump(void (*real_jump)(__jmp_buf_tag*, int), __jmp_buf_tag* place, int value) noexcept {
  if (by_turns()) abandon_wait();
  real_jump(place, value);
  __builtin_unreachable();
}

}  // namespace

}  // namespace preload

// Without the header, which gives a fortified program another name for them.

PRELOAD_EXPORT void longjmp(__jmp_buf_tag* place, int value) noexcept {
  preload::jump(preload::real().longjmp, place, value);
}

PRELOAD_EXPORT void _longjmp(__jmp_buf_tag* place, int value) noexcept {
  preload::jump(preload::real().longjmp, place, value);
}

PRELOAD_EXPORT void siglongjmp(__jmp_buf_tag* place, int value) noexcept {
  preload::jump(preload::real().longjmp, place, value);
}

PRELOAD_EXPORT void __longjmp_chk(__jmp_buf_tag* place, int value) noexcept {
  preload::jump(preload::real().longjmp_chk, place, value);
}
