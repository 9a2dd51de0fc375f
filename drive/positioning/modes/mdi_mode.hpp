#pragma once

#include "drive/positioning/modes/mode_context.hpp"

namespace drive {

/// Direct setpoint input: positioning (absolute or relative) and setting-up (velocity), with the transfer of each
/// setpoint by an edge or continuously.
class MdiMode {
 public:
  /// Whether a transfer asks for the mode.
  bool is_requested(const ModeContext& context) noexcept;
  /// Whether the mode may begin: enables and reference; otherwise the alarm says what is missing.
  bool may_start(ModeContext& context) noexcept;
  void start(ModeContext& context) noexcept;
  void run(ModeContext& context) noexcept;
  void abandon() noexcept;
  /// A request was refused by another mode: a continuous one comes again by itself.
  void stand_by(const ModeContext& context) noexcept { pending_ = context.inputs.mdi_continuous; }
  /// Flying referencing has moved the coordinates by @p by (LU).
  void shift(double by) noexcept;

  bool is_active() const noexcept { return active_; }
  bool is_setting_up() const noexcept { return setting_up_; }
  /// Whether the setpoint is on its way (r2684.15).
  bool has_task() const noexcept { return task_; }
  /// Whether the last setpoint was taken over (r2684.12).
  bool acknowledges() const noexcept { return acknowledges_; }
  /// Whether the target is an absolute one.
  bool is_absolute() const noexcept { return absolute_; }
  bool brakes() const noexcept { return rejected_; }

 private:
  /// What p2648, p2651, p2652 or p2654 say.
  struct Kind {
    bool absolute = false;
    int direction = 0;  ///< of an absolute target on a modulo axis: +1, -1 or 0 = shortest
  };
  static Kind kind_of(const PositionerInputs& inputs) noexcept;
  static double share(double given) noexcept;
  void take(ModeContext& context) noexcept;
  void take_position(ModeContext& context) noexcept;
  void take_velocity(ModeContext& context) noexcept;
  bool follows(const ModeContext& context) const noexcept;
  void reject(ModeContext& context) noexcept;
  void stop_or_go(ModeContext& context) noexcept;
  double target_of(const ModeContext& context, const Kind& kind) const noexcept;

  bool active_ = false;
  bool setting_up_ = false;
  bool task_ = false;
  bool absolute_ = false;
  bool begins_ = false;    // in this slice
  bool rejected_ = false;  // brakes to the end of the mode
  bool pending_ = false;   // continuous, and not yet begun
  bool acknowledges_ = false;
  double taken_position_ = 0.0;  // what was last taken over, of p2642
  double target_ = 0.0;
};

}  // namespace drive
