#pragma once

#include <chrono>

#include "libcanopen/base/time.hpp"
#include "libcanopen/pdo/pdo_cycle.hpp"
#include "unit/unit_parameters.hpp"

namespace device {

/// Watches the process data (p8699): they are missing if no RPDO of the unit has come for that time. It begins
/// with the first one that comes in Operational, and again with the first one after they were missing. The time is
/// rounded up to whole process-data cycles and judged where one ends.
class RpdoMonitor final : public unit::ParameterOwner {
 public:
  static constexpr std::uint16_t kParameter = 8699;

  /// Answers in @p parameters, which outlive this, for p8699.
  explicit RpdoMonitor(unit::UnitParameters& parameters) { parameters.answer(kParameter, *this); }

  /// p8699 is @p milliseconds from now on, 0 = off.
  void set_time(double milliseconds) noexcept {
    const std::chrono::duration<double, std::milli> exact{milliseconds};
    time_ = cycle_.whole(std::chrono::duration_cast<canopen::Duration>(exact));
    stop();
  }
  /// Judges in @p cycle from the next set_time() on.
  void set_cycle(const canopen::PdoCycle& cycle) noexcept { cycle_ = cycle; }
  /// An RPDO has come.
  void on_rpdo(canopen::TimePoint now) noexcept {
    if (time_ != canopen::Duration{0}) deadline_ = cycle_.next_from(now + time_);
  }
  /// Nothing is missing: Operational is over.
  void stop() noexcept { deadline_ = canopen::kNever; }
  /// When the process data are missing; kNever while nothing is watched.
  canopen::TimePoint deadline() const noexcept { return deadline_; }

  std::optional<drive::Refusal> take(const unit::ParameterPlace&, double value) noexcept override {
    set_time(value);
    return {};
  }

 private:
  canopen::PdoCycle cycle_{};
  canopen::Duration time_{0};
  canopen::TimePoint deadline_ = canopen::kNever;
};

}  // namespace device
