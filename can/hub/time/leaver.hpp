#pragma once

#include <functional>
#include <utility>

#include "can/hub/loop/clock.hpp"
#include "can/hub/loop/poll.hpp"
#include "can/hub/time/bus_time.hpp"

namespace hub {

/// A process that has left the time of the bus, and is about to end: its sockets close before its parent can see
/// that it has, and time must not go on between. One that lives on is waited for no longer than kPatience, and a
/// child that has not said which process it is, so that it cannot be watched, for kPatienceWithUnknown.
class BusTime::Leaver final : public Watch {
 public:
  static constexpr canopen::Duration kPatience = std::chrono::seconds{1};
  static constexpr canopen::Duration kPatienceWithUnknown = std::chrono::milliseconds{20};

  /// @p part is what it had, @p parent who had joined for it; @p had_turn: it left while it acted; @p on_end is
  /// told.
  Leaver(pid_t parent, Part part, bool had_turn, std::function<void(Leaver&)> on_end)
      : parent_{parent},
        part_{std::move(part)},
        had_turn_{had_turn},
        on_end_{std::move(on_end)},
        due_{monotonic_now() + (part_.end ? kPatience : kPatienceWithUnknown)} {}
  Leaver(const Leaver&) = delete;
  Leaver& operator=(const Leaver&) = delete;
  ~Leaver() override {
    if (poll_ != nullptr) poll_->remove(part_.end.get(), *this);
  }

  /// Has its end told as soon as it comes; else it is waited for as long as there is patience.
  void watch(Poll& poll) noexcept {
    if (part_.end && poll.add(part_.end.get(), EPOLLIN, *this)) poll_ = &poll;
  }
  /// It goes on, by another connection or without one: there is nothing to wait for, and nobody is told.
  void replace() noexcept {
    is_replaced_ = true;
    due_ = monotonic_now();
  }
  void on_events(std::uint32_t) noexcept override { on_end_(*this); }

  /// When it is waited for no longer, on the machine's clock.
  [[nodiscard]] canopen::TimePoint due() const noexcept { return due_; }
  [[nodiscard]] const Part& part() const noexcept { return part_; }
  [[nodiscard]] pid_t parent() const noexcept { return parent_; }
  [[nodiscard]] bool had_turn() const noexcept { return had_turn_; }
  [[nodiscard]] bool is_replaced() const noexcept { return is_replaced_; }

 private:
  pid_t parent_;
  Part part_;
  bool had_turn_;
  bool is_replaced_ = false;
  std::function<void(Leaver&)> on_end_;
  canopen::TimePoint due_;
  Poll* poll_ = nullptr;
};

}  // namespace hub
