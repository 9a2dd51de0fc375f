#pragma once

#include <chrono>

#include "libcanopen/base/time.hpp"
#include "service/log.hpp"
#include "service/service_events.hpp"

namespace axisd {

/// The loop of a service that has nothing but rare events: handles them, tells what its log has left out, and
/// feeds the watchdog of systemd if that asks for it.
class ServiceLoop {
 public:
  /// Of @p events and @p log, which outlive it. Throws std::system_error.
  ServiceLoop(ServiceEvents& events, const Log& log);
  ServiceLoop(const ServiceLoop&) = delete;
  ServiceLoop& operator=(const ServiceLoop&) = delete;
  ~ServiceLoop() = default;

  /// Waits for an event, at most until @p until, and handles one. False if others wait already.
  bool turn(canopen::TimePoint until = canopen::kNever);

 private:
  void feed_watchdog() noexcept;

  ServiceEvents& events_;
  const Log& log_;
  EventSource watchdog_;
  std::chrono::microseconds watchdog_period_{0};
  bool more_ = false;  ///< events wait, whatever the descriptor says
};

}  // namespace axisd
