#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include <systemd/sd-event.h>

namespace axisd {

/// Releases one sd-event object.
struct EventDeleter {
  void operator()(sd_event* event) const noexcept { sd_event_unref(event); }
  void operator()(sd_event_source* source) const noexcept { sd_event_source_disable_unref(source); }
};
/// A registration with the event loop; destroying it ends it, also from within its own callback.
using EventSource = std::unique_ptr<sd_event_source, EventDeleter>;

/// What is rare goes through sd-event: signals, the control socket, link changes, the watchdog. It is a guest in
/// the daemon's own loop, which looks at its descriptor only.
class ServiceEvents {
 public:
  /// Takes over SIGTERM and SIGINT for this process and feeds the watchdog if systemd asks for it. @p on_stop is
  /// called when the process shall end. Throws std::system_error.
  explicit ServiceEvents(std::function<void()> on_stop);

  /// Readable when dispatch() has something to do.
  int descriptor() const noexcept;
  /// Handles everything that is pending.
  void dispatch() noexcept;
  /// Calls @p handler with @p userdata while @p descriptor has one of @p events (EPOLLIN...). Throws
  /// std::system_error.
  EventSource watch(int descriptor, std::uint32_t events, sd_event_io_handler_t handler, void* userdata);

 private:
  static int on_signal(sd_event_source* source, const signalfd_siginfo* signal, void* self);
  void catch_signal(int signal);

  std::function<void()> on_stop_;
  std::unique_ptr<sd_event, EventDeleter> event_;
};

}  // namespace axisd
