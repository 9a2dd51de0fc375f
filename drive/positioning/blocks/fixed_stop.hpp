#pragma once

#include <cstdint>

#include "drive/positioning/modes/mode_context.hpp"

namespace drive {

/// Travel to a fixed stop: runs against it with the clamping torque, sees that it stands, and holds.
class FixedStop {
 public:
  /// The travel begins, with @p torque (N·m).
  void begin(double torque) noexcept;
  /// Clamped, the torque is another one.
  void change(double torque) noexcept { torque_ = torque; }
  /// A slice of @p duration (s); @p monitoring_time is p2545 (s).
  void run(ModeContext& context, double duration, double monitoring_time) noexcept;
  void end() noexcept { *this = {}; }

  bool is_active() const noexcept { return state_ != State::None; }         ///< r2683.14
  bool is_clamped() const noexcept { return state_ == State::Clamped; }     ///< r2683.12
  bool has_torque() const noexcept { return is_clamped() && has_torque_; }  ///< r2683.13
  double torque() const noexcept { return torque_; }                        ///< clamping torque (N·m)

 private:
  enum class State : std::uint8_t { None, Approaching, Clamped };

  State state_ = State::None;
  bool has_torque_ = false;
  bool is_left_ = false;  // F07484 has come
  double torque_ = 0.0;
  double waited_ = 0.0;  // s, for the torque
};

}  // namespace drive
