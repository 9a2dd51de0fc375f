#pragma once

#include <cstdint>
#include <string>

#include "farm/agent/plan/times.hpp"

namespace farm::agent {

/// What is known of a program that is to run: that of a unit, or the hub of a bus. One that ends by itself is
/// started again after a pause that grows.
class Process {
 public:
  enum class State : std::uint8_t { Off, Starting, On, Stopping };

  [[nodiscard]] State state() const noexcept { return state_; }
  [[nodiscard]] bool is_off() const noexcept { return state_ == State::Off; }
  /// Whether it runs, or is about to.
  [[nodiscard]] bool is_wanted() const noexcept { return state_ == State::Starting || state_ == State::On; }
  /// Whether it is off and no pause keeps it from being started at @p now.
  [[nodiscard]] bool may_start(canopen::TimePoint now) const noexcept { return is_off() && now >= again_; }
  /// When that will be; kNever if it is not off.
  [[nodiscard]] canopen::TimePoint next_start() const noexcept { return is_off() ? again_ : canopen::kNever; }
  /// How often it has ended by itself after it had run.
  [[nodiscard]] std::uint64_t restarts() const noexcept { return restarts_; }
  /// Why it does not run, in one line; empty if it does, or was not to.
  [[nodiscard]] const std::string& problem() const noexcept { return problem_; }

  void start() noexcept { state_ = State::Starting; }
  /// It runs since @p now.
  void on_started(canopen::TimePoint now);
  void stop() noexcept { state_ = State::Stopping; }
  /// It has ended, or could not be started, for the reason @p why; after stop() that is no problem.
  void on_ended(const std::string& why, canopen::TimePoint now);
  /// No pause is kept any more: what it is started with has changed.
  void forgive() noexcept;

 private:
  State state_ = State::Off;
  unsigned failures_ = 0;  ///< in a row
  std::uint64_t restarts_ = 0;
  canopen::TimePoint since_{};  ///< On
  canopen::TimePoint again_{};
  std::string problem_;
};

}  // namespace farm::agent
