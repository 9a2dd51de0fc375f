#pragma once

#include <functional>
#include <utility>

#include "can/hub/loop/clock.hpp"
#include "can/hub/loop/poll.hpp"
#include "can/hub/time/bus_time.hpp"

namespace hub {

/// A process that has left the time of the bus, and is about to end: its sockets close before its parent can see
/// that it has, and time must not go on between. One that lives on is waited for no longer than kPatience.
class BusTime::Leaver final : public Watch {
 public:
  static constexpr canopen::Duration kPatience = std::chrono::seconds{1};

  /// @p part is what it had, @p parent who had joined for it; @p on_end is told.
  Leaver(pid_t parent, Part part, std::function<void(Leaver&)> on_end)
      : parent_{parent}, part_{std::move(part)}, on_end_{std::move(on_end)}, due_{monotonic_now() + kPatience} {}
  ~Leaver() override {
    if (poll_ != nullptr) poll_->remove(part_.end.get(), *this);
  }

  /// False if nothing would tell its end.
  [[nodiscard]] bool watch(Poll& poll) noexcept {
    if (!part_.end || !poll.add(part_.end.get(), EPOLLIN, *this)) return false;
    poll_ = &poll;
    return true;
  }
  void on_events(std::uint32_t) noexcept override { on_end_(*this); }

  /// When it is waited for no longer, on the machine's clock.
  [[nodiscard]] canopen::TimePoint due() const noexcept { return due_; }
  [[nodiscard]] const Part& part() const noexcept { return part_; }
  [[nodiscard]] pid_t parent() const noexcept { return parent_; }

 private:
  pid_t parent_;
  Part part_;
  std::function<void(Leaver&)> on_end_;
  canopen::TimePoint due_;
  Poll* poll_ = nullptr;
};

}  // namespace hub
