#pragma once

#include <span>

#include <poll.h>

#include "can/clock/party.hpp"

namespace bus {

class TimeShare;

/// How a thread of a program waits that may live by the time of its bus.
class Sleeper {
 public:
  /// By @p time, which outlives this; nullptr: by the machine's. From within the thread, or before there is one.
  explicit Sleeper(TimeShare* time);

  /// Until one of @p descriptors is ready, @p until the latest; on return their `revents` tell. By the machine's
  /// time a signal ends it, too.
  void sleep(std::span<pollfd> descriptors, canopen::TimePoint until) noexcept;

 private:
  TimeShare* time_;
  Party* party_;
};

}  // namespace bus
