#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>

#include <systemd/sd-event.h>

#include "service/told_timers.hpp"

namespace axisd {

/// Releases one sd-event object.
struct EventDeleter {
  void operator()(sd_event* event) const noexcept { sd_event_unref(event); }
  void operator()(sd_event_source* source) const noexcept { sd_event_source_disable_unref(source); }
};
/// A registration with the event loop; destroying it ends it, also from within its own callback.
using EventSource = std::unique_ptr<sd_event_source, EventDeleter>;

/// What is rare goes through sd-event: signals, the control socket, link changes, the end of writes. It is a guest
/// in the daemon's own loop, which looks at its descriptor only.
class ServiceEvents {
 public:
  /// Takes over SIGTERM, SIGINT and, unless it is ignored (nohup), SIGHUP for this process. @p on_stop is called
  /// when the process shall end. Throws std::system_error.
  explicit ServiceEvents(std::function<void()> on_stop);
  /// Of a thread beside that one: signals are none of its business. Throws std::system_error.
  ServiceEvents();

  /// Readable when dispatch() has something to do.
  int descriptor() const noexcept;
  /// When dispatch() has something to do whatever the descriptor says: a timer of a process that does not live by
  /// the machine's clock; kNever in one that does.
  canopen::TimePoint due() const noexcept { return timers_.due(); }
  /// Handles one of the events that are pending, the one that has waited longest, and one timer that is due. True
  /// if more events wait: the descriptor need not say so.
  bool dispatch() noexcept;
  /// A timer that calls @p handler with @p userdata once for each start(); it has all that it needs for that.
  /// Throws std::system_error.
  EventSource timer(sd_event_time_handler_t handler, void* userdata);
  /// Lets @p timer ring @p delay from now.
  static void start(const EventSource& timer, std::chrono::microseconds delay) noexcept;
  /// Calls @p handler with @p userdata while @p descriptor has one of @p events (EPOLLIN...). Throws
  /// std::system_error.
  EventSource watch(int descriptor, std::uint32_t events, sd_event_io_handler_t handler, void* userdata);

 private:
  static int on_signal(sd_event_source* source, const signalfd_siginfo* signal, void* self);
  void catch_signal(int signal);

  std::function<void()> on_stop_;
  ToldTimers timers_{};
  std::unique_ptr<sd_event, EventDeleter> event_;
};

}  // namespace axisd
