#include "daemon/service_events.hpp"

#include <csignal>
#include <system_error>

namespace axisd {
namespace {

/// Throws for a negative @p result of an sd-event call.
void require(int result, const char* what) {
  if (result < 0) throw std::system_error{-result, std::generic_category(), what};
}

}  // namespace

ServiceEvents::ServiceEvents(std::function<void()> on_stop) : on_stop_{std::move(on_stop)} {
  sd_event* event = nullptr;
  require(sd_event_new(&event), "cannot create an event loop");
  event_.reset(event);
  for (const int signal : {SIGTERM, SIGINT}) catch_signal(signal);
  require(sd_event_set_watchdog(event_.get(), 1), "cannot feed the watchdog");
  dispatch();
}

void ServiceEvents::catch_signal(int signal) {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, signal);
  sigprocmask(SIG_BLOCK, &set, nullptr);
  require(sd_event_add_signal(event_.get(), nullptr, signal, &ServiceEvents::on_signal, this),
          "cannot catch a signal");
}

int ServiceEvents::on_signal(sd_event_source*, const signalfd_siginfo*, void* self) {
  static_cast<ServiceEvents*>(self)->on_stop_();
  return 0;
}

int ServiceEvents::descriptor() const noexcept {
  return sd_event_get_fd(event_.get());
}

void ServiceEvents::dispatch() noexcept {
  if (sd_event_get_state(event_.get()) == SD_EVENT_ARMED && sd_event_wait(event_.get(), 0) > 0) {
    sd_event_dispatch(event_.get());
  }
  // sd-event wants to be prepared again before its descriptor means anything.
  while (sd_event_get_state(event_.get()) == SD_EVENT_INITIAL && sd_event_prepare(event_.get()) > 0) {
    sd_event_dispatch(event_.get());
  }
}

EventSource ServiceEvents::watch(int descriptor, std::uint32_t events, sd_event_io_handler_t handler,
                                 void* userdata) {
  sd_event_source* source = nullptr;
  require(sd_event_add_io(event_.get(), &source, descriptor, events, handler, userdata),
          "cannot watch a descriptor");
  return EventSource{source};
}

}  // namespace axisd
