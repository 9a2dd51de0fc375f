#pragma once

#include <chrono>

#include "os/clock.hpp"

namespace fakes {

/// The time of the process while this lives: it stands, however long the machine takes, until a test moves it.
class StandingTime final : public os::OtherTime {
 public:
  StandingTime() { os::use_time(*this); }
  ~StandingTime() override { os::other_time = nullptr; }

  void pass(std::chrono::nanoseconds time) noexcept { now_ += time; }

  std::chrono::nanoseconds monotonic() const noexcept override { return now_; }
  std::chrono::nanoseconds wall() const noexcept override { return now_; }
  bool stands_while_acting() const noexcept override { return true; }
  void wait_readable(int) noexcept override {}
  void note_sent() noexcept override {}
  void note_touched() noexcept override {}
  void note_handed_over() noexcept override {}

 private:
  std::chrono::nanoseconds now_ = os::machine_time(CLOCK_MONOTONIC);
};

}  // namespace fakes
