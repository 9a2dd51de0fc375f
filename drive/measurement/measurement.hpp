#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "drive/messages/cause.hpp"
#include "motor/drive_train.hpp"

namespace drive {
namespace explanation {
struct Reason;
}

/// Speed and torques of the motor as means over a process-data cycle, and what the motor encoder has to say.
class Measurement {
 public:
  struct Settings {};

  /// With an encoder of @p counts_to_speed radians an increment.
  explicit Measurement(double counts_to_speed) noexcept : counts_to_speed_{counts_to_speed} {}

  /// The cycle is over.
  void measure(const motor::DriveTrain& train) noexcept {
    const motor::StepSums<double>& sums = train.sums();
    const double steps = std::max(1.0, sums.steps);
    const std::int64_t counts = train.signals().encoder_counts;
    const auto moved = static_cast<double>(counts - counts_);
    const bool has_encoder = train.settings().mode == motor::ControlMode::Encoder;
    time_ = steps * motor::kControlPeriod;
    speed_ = has_encoder ? moved * counts_to_speed_ / time_ : sums.speed / steps;
    torque_demand_ = sums.torque_setpoint / steps;
    torque_ = sums.torque / steps;
    counts_ = counts;
  }
  /// What the encoder has found wrong until now.
  void observe(const motor::Encoder& encoder) noexcept {
    zero_mark_deviation_ = std::abs(static_cast<double>(encoder.status().zero_mark_deviation));
    signal_lost_ = encoder.status().signal_lost ? 1.0 : 0.0;
  }

  double speed() const noexcept { return speed_; }                  ///< r0063 (rad/s)
  double torque_demand() const noexcept { return torque_demand_; }  ///< r0079 (N·m)
  double torque() const noexcept { return torque_; }                ///< r0080 (N·m)
  std::int64_t counts() const noexcept { return counts_; }          ///< increments since power-on
  double duration() const noexcept { return time_; }                ///< of the last cycle, in steps (s)
  /// Of the last distance of zero marks (increments, absolute).
  double zero_mark_deviation() const noexcept { return zero_mark_deviation_; }
  double signal_lost() const noexcept { return signal_lost_; }  ///< 1 = no signals

  /// Its reasons that an axis does not turn.
  static std::span<const explanation::Reason> reasons() noexcept;

  Settings settings{};

 private:
  double counts_to_speed_;
  double time_ = motor::kControlPeriod;
  double speed_ = 0.0;
  double torque_demand_ = 0.0;
  double torque_ = 0.0;
  std::int64_t counts_ = 0;
  double zero_mark_deviation_ = 0.0;
  double signal_lost_ = 0.0;
};

// clang-format off
template <>
inline constexpr auto causes_of<Measurement> = std::array{
    CauseRow<Measurement>{31100, &Measurement::zero_mark_deviation, Side::Above, cause::kYes, cause::kNone, cause::kAtOnce, Pulses::Any, &Measurement::zero_mark_deviation, 1.0, "increments between two zero marks"},
    CauseRow<Measurement>{31116, &Measurement::signal_lost, Side::Above, cause::kYes, cause::kNone, cause::kAtOnce, Pulses::Any, nullptr, cause::kNone, "encoder without signals"},
};
// clang-format on

}  // namespace drive
