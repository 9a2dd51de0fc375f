#pragma once

#include <chrono>
#include <cstdint>
#include <list>

#include <systemd/sd-event.h>

#include "libcanopen/base/time.hpp"

namespace axisd {

/// The timers of a process that lives by another clock than the machine's, which sd-event alone knows: a source
/// that never rings is what their owner holds, and whoever waits asks when one is due.
class ToldTimers {
 public:
  ToldTimers() = default;
  ToldTimers(const ToldTimers&) = delete;
  ToldTimers& operator=(const ToldTimers&) = delete;
  ~ToldTimers();

  /// A timer that calls @p handler with @p userdata once for each start(), as long as there is the source.
  /// Negative errno if sd-event refuses.
  int add(sd_event* event, sd_event_source** source, sd_event_time_handler_t handler, void* userdata);
  /// Lets the timer behind @p source ring @p delay from now.
  static void start(sd_event_source* source, std::chrono::microseconds delay) noexcept;
  /// When the next one rings; kNever: none.
  [[nodiscard]] canopen::TimePoint due() const noexcept;
  /// Has the one ring that is due at @p now and has been for the longest time, if there is one.
  void ring_one(canopen::TimePoint now) noexcept;

 private:
  struct Timer {
    ToldTimers* owner;
    sd_event_source* source;
    sd_event_time_handler_t handler;
    void* userdata;
    canopen::TimePoint due = canopen::kNever;
  };
  static void forget(void* timer) noexcept;

  std::list<Timer*> timers_{};  ///< each of its source
};

}  // namespace axisd
