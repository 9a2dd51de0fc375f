#include "service/service_events.hpp"

#include <csignal>
#include <system_error>

#include "os/clock.hpp"

namespace axisd {
namespace {

/// Throws for a negative @p result of an sd-event call.
void require(int result, const char* what) {
  if (result < 0) throw std::system_error{-result, std::generic_category(), what};
}

bool is_ignored(int signal) noexcept {
  struct sigaction present {};
  return ::sigaction(signal, nullptr, &present) == 0 && present.sa_handler == SIG_IGN;
}

}  // namespace

ServiceEvents::ServiceEvents() {
  sd_event* event = nullptr;
  require(sd_event_new(&event), "cannot create an event loop");
  event_.reset(event);
  dispatch();
}

ServiceEvents::ServiceEvents(std::function<void()> on_stop) : ServiceEvents{} {
  // NOLINTNEXTLINE(cppcoreguidelines-prefer-member-initializer): the other constructor has made the loop
  on_stop_ = std::move(on_stop);
  for (const int signal : {SIGTERM, SIGINT}) catch_signal(signal);
  if (!is_ignored(SIGHUP)) catch_signal(SIGHUP);
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

bool ServiceEvents::dispatch() noexcept {
  sd_event* const event = event_.get();
  if (timers_.due() != canopen::kNever) timers_.ring_one(canopen::TimePoint{os::monotonic_time()});
  if (sd_event_get_state(event) == SD_EVENT_ARMED) sd_event_wait(event, 0);
  if (sd_event_get_state(event) == SD_EVENT_PENDING) sd_event_dispatch(event);
  // sd-event wants to be prepared again before its descriptor means anything.
  if (sd_event_get_state(event) == SD_EVENT_INITIAL) sd_event_prepare(event);
  return sd_event_get_state(event) == SD_EVENT_PENDING;
}

EventSource ServiceEvents::timer(sd_event_time_handler_t handler, void* userdata) {
  constexpr std::uint64_t kNever = UINT64_MAX;
  constexpr std::uint64_t kAccuracy = 1000;  // µs; a zero would mean 250 ms
  sd_event_source* source = nullptr;
  if (os::other_time != nullptr) {
    require(timers_.add(event_.get(), &source, handler, userdata), "cannot create a timer");
    return EventSource{source};
  }
  require(sd_event_add_time(event_.get(), &source, CLOCK_MONOTONIC, kNever, kAccuracy, handler, userdata),
          "cannot create a timer");
  sd_event_source_set_enabled(source, SD_EVENT_OFF);
  return EventSource{source};
}

void ServiceEvents::start(const EventSource& timer, std::chrono::microseconds delay) noexcept {
  if (os::other_time != nullptr) return ToldTimers::start(timer.get(), delay);
  sd_event_source_set_time_relative(timer.get(), static_cast<std::uint64_t>(delay.count()));
  sd_event_source_set_enabled(timer.get(), SD_EVENT_ONESHOT);
}

EventSource ServiceEvents::watch(int descriptor, std::uint32_t events, sd_event_io_handler_t handler,
                                 void* userdata) {
  sd_event_source* source = nullptr;
  require(sd_event_add_io(event_.get(), &source, descriptor, events, handler, userdata),
          "cannot watch a descriptor");
  return EventSource{source};
}

}  // namespace axisd
