#pragma once

#include "can/hub/loop/poll.hpp"
#include "libcanopen/base/time.hpp"
#include "os/timer.hpp"

namespace hub {

/// Ends the wait of a Poll at a time.
class Timer final : public Watch {
 public:
  /// std::system_error if the kernel has no descriptor left.
  explicit Timer(Poll& poll);

  /// The wait shall end at @p when at the latest. Costs a system call only if @p when is earlier than what was
  /// wanted before: for a deadline that moves away at every frame the wait ends once too often instead.
  void wake_at(canopen::TimePoint when) noexcept;
  void on_events(std::uint32_t events) noexcept override;

 private:
  os::Timer timer_;
  canopen::TimePoint armed_ = canopen::kNever;
};

}  // namespace hub
