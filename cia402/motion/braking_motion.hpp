#pragma once

#include <cstdint>

#include "cia402/base/demand.hpp"

namespace cia402 {

/// Ends a motion that a mode was leading: halt, quick stop, fault reaction, disable operation.
///
/// It takes over where the demand is. Of a mode that led velocity or torque, position (and velocity) of that are
/// the actual ones.
class BrakingMotion {
 public:
  /// Along a ramp with @p deceleration (position units/s², positive), then holds where that has led.
  void ramp(const Motion& present, double deceleration) noexcept;
  /// With all torque there is: the demand of the velocity is 0 at once, and where the axis comes to rest it is
  /// held.
  void stop_hard(const Motion& present) noexcept;
  /// Takes the torque back by @p slope (N·m/s, positive; infinite = at once) and leaves the axis without torque.
  void release_torque(const Motion& present, double slope) noexcept;

  /// The next 1 ms.
  Demand cycle(const Actual& actual) noexcept;
  /// Whether the demand is at rest; with stop_hard(), whether the axis has come to rest.
  bool stands() const noexcept { return state_ == State::Standing; }

 private:
  enum class State : std::uint8_t { Standing, Ramping, StoppingHard, Releasing };

  void ramp_on() noexcept;
  void stop_on(const Actual& actual) noexcept;
  void release_on() noexcept;

  State state_ = State::Standing;
  Lead lead_ = Lead::Position;
  Motion motion_{};
  double slope_ = 0.0;    // units/s² or N·m/s
  double fastest_ = 0.0;  // units/s with its sign, since the stop began
};

}  // namespace cia402
