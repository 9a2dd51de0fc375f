#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace drive {
/// The position controller with its monitors (function diagrams 4015 and 4020): from the setpoint and the actual
/// value, in LU, to a speed setpoint.
class PositionControl {
 public:
  static constexpr double kSlice = 1e-3;  ///< p0115[4] (s)

  struct Settings {
    using Block = PositionControl;

    double smoothing_time = 0.0;             ///< p2533 (s)
    double precontrol = 0.0;                 ///< p2534, 1 = 100 %
    double balancing_dead_time = 0.0;        ///< p2535, slices beyond two
    double balancing_time = 0.0;             ///< p2536 (s)
    double gain = 0.0;                       ///< p2538 (1/s)
    double integral_time = 0.0;              ///< p2539 (s), 0 = none
    double output_limit = 0.0;               ///< p2540 (rad/s)
    double standstill_window = 0.0;          ///< p2542 (LU), 0 = off
    double standstill_time = 0.0;            ///< p2543 (s)
    double positioning_window = 0.0;         ///< p2544 (LU), 0 = off
    double positioning_time = 0.0;           ///< p2545 (s)
    double following_error_tolerance = 0.0;  ///< p2546 (LU), 0 = off
    double cam_1 = 0.0;                      ///< p2547 (LU)
    double cam_2 = 0.0;                      ///< p2548 (LU)
    double inertia = 0.0;                    ///< p2567 (kg·m²)
  };
  struct Inputs {
    using Block = PositionControl;

    double setpoint = 0.0;               ///< p2530 (LU)
    double velocity = 0.0;               ///< p2531 (LU/s)
    double actual_position = 0.0;        ///< p2532 (LU)
    double gain_share = 1.0;             ///< p2537
    double output_limit = 0.0;           ///< p2541 (rad/s)
    double units_per_revolution = 0.0;   ///< p2555, of the motor (LU)
    bool enable_1 = false;               ///< p2549
    bool enable_2 = false;               ///< p2550
    bool setpoint_fixed = false;         ///< p2551
    bool travels_to_fixed_stop = false;  ///< p2552
    bool fixed_stop_reached = false;     ///< p2553
    bool has_task = false;               ///< p2554

    friend bool operator==(const Inputs&, const Inputs&) = default;
  };
  /// What it is told in a slice beside its inputs.
  struct Slice {
    bool is_possible = false;        ///< position valid, control with encoder, no fault reaction
    bool requests_tracking = false;  ///< a fault reaction, OFF2 or OFF3 runs
    double modulo_range = 0.0;       ///< LU, 0 = none
    double stop_deviation = 0.0;     ///< p2634 (LU)
    double stop_window = 0.0;        ///< p2635 (LU)
  };
  /// What a slice has found wrong, once.
  struct Found {
    bool standstill = false;       ///< F07450
    bool position = false;         ///< F07451
    bool following_error = false;  ///< F07452
  };

  /// A slice with the inputs as they are.
  void run(const Slice& slice) noexcept;
  /// The coordinates of setpoint and actual value have moved by @p by (LU).
  void shift(double by) noexcept;
  /// Setpoint and actual value have become @p position (LU).
  void place(double position) noexcept;
  /// Power-off: no input has come yet.
  void power_off() noexcept;

  const Found& found() const noexcept { return found_; }
  bool is_enabled() const noexcept { return enabled_; }                 ///< r2526.3
  double setpoint() const noexcept { return setpoint_; }                ///< r2556 (LU)
  double deviation() const noexcept { return deviation_; }              ///< r2557, r2565 (LU)
  double proportional() const noexcept { return proportional_; }        ///< r2558 (rad/s)
  double integral() const noexcept { return integral_; }                ///< r2559 (rad/s)
  double limited() const noexcept { return limited_; }                  ///< r2560 (rad/s)
  double precontrol() const noexcept { return precontrol_; }            ///< r2561 (rad/s)
  double output() const noexcept { return limited_ + precontrol_; }     ///< r2562 (rad/s)
  double following_error() const noexcept { return following_error_; }  ///< r2563 (LU)
  double torque_precontrol() const noexcept { return torque_; }         ///< r2564 (N·m)
  double setpoint_speed() const noexcept { return setpoint_speed_; }    ///< r2566 (rad/s)
  /// r2526 but for what the actual position knows.
  std::uint16_t status() const noexcept;
  bool is_in_position() const noexcept { return in_position_; }                              ///< r2684.10
  bool is_following() const noexcept { return following_; }                                  ///< r2684.8
  bool is_below_cam_1() const noexcept { return inputs.actual_position <= settings.cam_1; }  ///< r2683.8
  bool is_below_cam_2() const noexcept { return inputs.actual_position <= settings.cam_2; }  ///< r2683.9
  bool is_at_fixed_stop() const noexcept { return fixed_stop_; }

  Settings settings{};
  Inputs inputs{};

 private:
  static constexpr std::size_t kDelay = 6;  // slices

  double radians(double units) const noexcept;
  void lead_setpoint() noexcept;
  double delayed() const noexcept;
  void rest() noexcept;
  void control(double modulo_range) noexcept;
  void follow_model(double former) noexcept;
  void watch(const Slice& slice) noexcept;
  void watch_fixed_stop(const Slice& slice) noexcept;
  void watch_standstill() noexcept;

  std::array<double, kDelay> past_{};  // setpoints, the newest first
  double smoothed_ = 0.0;
  double setpoint_ = 0.0;
  double deviation_ = 0.0;
  double proportional_ = 0.0;
  double integral_ = 0.0;
  double limited_ = 0.0;
  double precontrol_ = 0.0;
  double model_ = 0.0;  // LU, where the axis would be
  double following_error_ = 0.0;
  double torque_ = 0.0;
  double setpoint_speed_ = 0.0;
  double standing_ = 0.0;  // s, since the setpoint is fixed
  double stop_position_ = 0.0;
  Found found_{};
  bool enabled_ = false;
  bool is_limited_ = false;
  bool requests_tracking_ = false;
  bool in_position_ = false;
  bool following_ = true;
  bool position_checked_ = false;
  bool fixed_stop_ = false;
  bool stop_left_ = false;
};

}  // namespace drive
