#pragma once

#include "motor/math/space_vector.hpp"
#include "tests/motor/reference/reference_file.hpp"

namespace reference {

/// Speed controller of the reference solutions: PI, nothing integrated while it is limited, unless outwards of it.
class SpeedPi {
 public:
  SpeedPi(double gain, double integral_time, double torque_limit, double period) noexcept;
  /// With Kp_n, Tn_n, T_max and T_s of the "controller" of @p file.
  explicit SpeedPi(const File& file);

  /// Torque (N·m) for a setpoint and a speed (rad/s).
  double step(double setpoint, double speed) noexcept;

 private:
  double gain_;
  double integral_gain_;
  double limit_;
  double integral_ = 0.0;
};

/// What a controller measures at a sample, without any error.
struct Measured {
  motor::SpaceVector current{};  ///< stator frame (A)
  double angle = 0.0;            ///< electrical (rad)
  double speed = 0.0;            ///< mechanical (rad/s)
};

/// REFCTL-PM: speed and current control of a synchronous machine with i_d = 0.
class SynchronousControl {
 public:
  explicit SynchronousControl(const File& file);

  /// Voltage of the next period in the stator frame (V).
  motor::SpaceVector step(double speed_setpoint, const Measured& measured);
  double torque_setpoint() const noexcept { return torque_; }
  double q_current_setpoint() const noexcept { return i_q_setpoint_; }

 private:
  SpeedPi speed_;
  double period_, pole_pairs_, l_d_, l_q_, magnet_flux_, current_limit_, voltage_limit_;
  double kp_d_, kp_q_, ki_d_, ki_q_;
  double torque_ = 0.0;
  double i_q_setpoint_ = 0.0;
  motor::SpaceVector integral_{};
};

/// REFCTL-IM: speed and current control of an induction machine in the coordinates of a rotor flux model.
class InductionControl {
 public:
  explicit InductionControl(const File& file);

  /// Voltage of the next period in the stator frame (V); without the speed controller while it magnetises.
  motor::SpaceVector step(bool magnetising, double speed_setpoint, const Measured& measured);
  double torque_setpoint() const noexcept { return torque_; }
  double q_current_setpoint() const noexcept { return i_q_setpoint_; }
  double flux() const noexcept { return flux_; }
  /// Unit vector of the model's flux at the last sample.
  motor::SpaceVector direction() const noexcept { return direction_; }

 private:
  SpeedPi speed_;
  double period_, pole_pairs_, rotor_resistance_, leakage_, magnetising_, flux_setpoint_;
  double current_limit_, voltage_limit_, kp_, ki_;
  double torque_ = 0.0;
  double i_q_setpoint_ = 0.0;
  double flux_ = 0.0;
  double angle_ = 0.0;
  motor::SpaceVector direction_{1.0, 0.0};
  motor::SpaceVector integral_{};
};

/// REFCTL-VF: voltage over frequency with boost on a ramp.
class FrequencyControl {
 public:
  explicit FrequencyControl(const File& file);

  /// Voltage of the period from @p time (s) on, in the stator frame (V).
  motor::SpaceVector step(double time);
  double frequency() const noexcept { return frequency_; }

 private:
  double period_, rated_voltage_, rated_frequency_, set_frequency_, boost_, on_, start_, ramp_, voltage_limit_;
  double frequency_ = 0.0;
  double angle_ = 0.0;
};

}  // namespace reference
