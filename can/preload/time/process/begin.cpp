// What happens at load: whose time the process lives by.
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include "can/preload/calls/exported.hpp"
#include "can/preload/hub.hpp"
#include "can/preload/next.hpp"
#include "can/preload/time/base/clock.hpp"
#include "can/preload/time/base/hidden.hpp"
#include "can/preload/time/base/real.hpp"
#include "can/preload/time/process/child.hpp"
#include "can/preload/time/process/environment.hpp"
#include "can/preload/time/turn/touch.hpp"
#include "can/preload/time/turn/turn.hpp"
#include "can/preload/time/wait/scheduler.hpp"

namespace preload {

namespace {

/// Programs that take part by themselves, as axisd does, have a symbol of this name.
bool takes_part_by_itself() noexcept {
  return dlsym(RTLD_DEFAULT, "can_bus_native_time") != nullptr;
}

bool is_wanted(userbus::TimeWish& wish) noexcept {
  const char* const text = getenv("CAN_TIME");
  return text != nullptr && userbus::read_time(text, strlen(text), wish) && wish.mode != userbus::TimeMode::Real;
}

void begin_by(int socket, const userbus::TimePage& page) noexcept {
  if (page.mode == userbus::TimeMode::Scaled) {
    close_hidden(socket);  // nobody takes turns
    return go_scaled(page.scale, page.begin_ns, page.machine_begin_ns, page.wall_offset_ns);
  }
  {
    const TimeLock lock;
    this_thread();
  }
  note_environment();
  go_by_turns(page.wall_offset_ns);
  begin_to_see_writes();
  watch_forks();
  take_part(socket);
}

/// Behind the library's own begin, before the constructors of the program and of its libraries.
[[gnu::constructor(102)]] void begin_time() {
  userbus::TimeWish wish{};
  if (!is_wanted(wish)) return;
  real();
  if (takes_part_by_itself()) return;
  int socket = userbus::inherited_clock();
  socket = hide(socket < 0 ? join_time(getpid()) : socket);
  if (socket < 0) return;
  fcntl(socket, F_SETFD, FD_CLOEXEC);
  const userbus::TimePage* const page = userbus::map_time(socket);
  if (page != nullptr) return begin_by(socket, *page);
  close_hidden(socket);
  report_bus("goes by the machine's time, not by that of CAN_TIME");
}

[[gnu::destructor]] void end_time() {
  tell_present();
}

}  // namespace

}  // namespace preload

/// 1 if the clocks of the process go by the time of a bus: a program that could join it by itself does not then.
PRELOAD_EXPORT int can_bus_keeps_time() noexcept {
  return preload::by_machine() ? 0 : 1;
}
