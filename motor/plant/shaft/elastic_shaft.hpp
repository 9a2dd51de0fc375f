#pragma once

#include "motor/data/load.hpp"
#include "motor/data/machine_data.hpp"
#include "motor/data/plant_data.hpp"
#include "motor/math/runge_kutta.hpp"
#include "motor/plant/shaft/friction.hpp"
#include "motor/plant/shaft/load_torque.hpp"
#include "motor/plant/shaft/step_start.hpp"

namespace motor {

/// Spring and damper between two masses, with play; it pushes with either flank and never pulls.
class CouplingTorque {
 public:
  /// What acts on the load (N·m): what the spring holds, and with the damper.
  struct Push {
    double spring = 0.0;
    double total = 0.0;
  };

  explicit CouplingTorque(const Coupling& coupling) noexcept
      : stiffness_{coupling.stiffness}, damping_{coupling.damping}, play_{0.5 * coupling.backlash} {}

  /// At @p twist (rad) and its change (rad/s).
  Push at(double twist, double change) const noexcept {
    if (play_ <= 0.0) return {stiffness_ * twist, stiffness_ * twist + damping_ * change};
    const double bent = beyond_play(twist);
    const double spring = stiffness_ * bent;
    const double total = spring + damping_ * change;
    return {spring, total * bent > 0.0 ? total : 0.0};
  }
  /// Energy in the spring (J).
  double stored(double twist) const noexcept {
    const double bent = beyond_play(twist);
    return 0.5 * stiffness_ * bent * bent;
  }

 private:
  double beyond_play(double twist) const noexcept {
    if (twist > play_) return twist - play_;
    return twist < -play_ ? twist + play_ : 0.0;
  }

  double stiffness_;
  double damping_;
  double play_;
};

/// Rotor and load as two masses; each has its own friction.
class ElasticShaft {
 public:
  static constexpr bool kPlain = false;

  struct Rate;
  /// Angles turned since the start of the step (rad), and speeds (rad/s).
  struct ShaftState {
    double angle = 0.0;
    double speed = 0.0;
    double load_angle = 0.0;
    double load_speed = 0.0;

    ShaftState moved(const Rate& rate, double h) const noexcept {
      return {angle + h * rate.speed, speed + h * rate.acceleration, load_angle + h * rate.load_speed,
              load_speed + h * rate.load_acceleration};
    }
  };
  struct Rate {
    double speed;              ///< (rad/s)
    double acceleration;       ///< (rad/s²)
    double load_speed;         ///< (rad/s)
    double load_acceleration;  ///< (rad/s²)
    double square;             ///< of the rotor's speed (rad²/s²)
    double load_square;        ///< of the load's speed (rad²/s²)
    double load;               ///< power into the load (W)
    double damping;            ///< power lost in coupling and end stops (W)

    static Rate summed(const Rate& a, const Rate& b, const Rate& c, const Rate& d) noexcept {
      return {stage_sum(a.speed, b.speed, c.speed, d.speed),
              stage_sum(a.acceleration, b.acceleration, c.acceleration, d.acceleration),
              stage_sum(a.load_speed, b.load_speed, c.load_speed, d.load_speed),
              stage_sum(a.load_acceleration, b.load_acceleration, c.load_acceleration, d.load_acceleration),
              stage_sum(a.square, b.square, c.square, d.square),
              stage_sum(a.load_square, b.load_square, c.load_square, d.load_square),
              stage_sum(a.load, b.load, c.load, d.load),
              stage_sum(a.damping, b.damping, c.damping, d.damping)};
    }
  };

  ElasticShaft(const MachineData& machine, const Load& load) noexcept;

  ShaftState state() const noexcept { return {0.0, speed_, 0.0, load_speed_}; }
  double speed() const noexcept { return speed_; }
  /// Whether anything on it stands, so that the torque at the start of a step counts.
  bool stands() const noexcept { return speed_ == 0.0; }
  double load_speed() const noexcept { return load_speed_; }
  double twist() const noexcept { return twist_; }
  /// What hangs on the load (N·m) where the last step began.
  double load_torque() const noexcept { return load_.at(load_speed_, 0.0, 0.0); }
  void set_speed(double speed) noexcept { speed_ = load_speed_ = speed; }
  /// Whether anything turns faster than @p limit (rad/s) after a step in which the rotor made @p rotor.
  bool is_beyond(const Motion& rotor, double limit) const noexcept {
    return std::abs(rotor.speed) > limit || std::abs(load_speed_) > limit;
  }
  /// Takes away what turns faster than @p limit (rad/s); the energy that goes with it (J).
  double slow_down(double limit) noexcept;
  /// Replaces constant load torque and friction torque (N·m).
  void set_load(double constant, double friction) noexcept {
    load_.set_constant(constant);
    load_friction_.coulomb = own_load_friction_ + friction;
  }
  /// Inertia and friction of the load become those of @p load; the torques that were set stay.
  void set_body(const MachineData& machine, const Load& load) noexcept;
  /// Friction of the brake on the rotor (N·m), 0 = open.
  void set_brake(double torque) noexcept { friction_.coulomb = open_friction_ + torque; }

  /// Decides for the coming step which masses hold fast against @p torque of the machine (N·m).
  void begin(const StepStart& start, double torque) noexcept;
  Rate rate(const ShaftState& z, double torque, double time) const noexcept {
    const double change = z.speed - z.load_speed;
    const CouplingTorque::Push shaft = coupling_.at(twist_ + z.angle - z.load_angle, change);
    const EndStopTorque::Push stop = stop_at(z);
    const double load = load_.at(z.load_speed, z.load_angle, time);
    return {z.speed,
            (torque - grip_.torque - drag_ * z.speed - shaft.total) * active_inverse_,
            z.load_speed,
            (shaft.total - load_grip_.torque - load_viscous_ * z.load_speed - load - stop.total) *
                load_active_inverse_,
            z.speed * z.speed,
            z.load_speed * z.load_speed,
            load * z.load_speed,
            (shaft.total - shaft.spring) * change + (stop.total - stop.spring) * z.load_speed};
  }
  /// Takes over the step of @p h (s) that was made with the summed rates @p sum, and says where its energy went.
  Motion finish(const Rate& sum, double h, PlantEnergies& energies) noexcept;
  double kinetic() const noexcept;
  /// Energy in the springs with the rotor at @p angle (rad since power-on).
  double spring(double angle) const noexcept { return coupling_.stored(twist_) + stops_.stored(angle - twist_); }
  /// Whether both stand, and stay so without torque of the machine, with the rotor at @p angle (rad since
  /// power-on).
  bool rests(double angle) const noexcept;

 private:
  EndStopTorque::Push stop_at(const ShaftState& z) const noexcept {
    return stops_.present() ? stops_.at(start_angle_ + z.load_angle, z.load_speed) : EndStopTorque::Push{};
  }

  double inertia_;
  double inverse_inertia_;
  double load_inertia_;
  double load_inverse_inertia_;
  DryFriction friction_;
  double open_friction_;  // of friction_.coulomb without the brake
  DryFriction load_friction_;
  double own_load_friction_;  // of load_friction_.coulomb
  double hysteresis_;
  double viscous_;
  double eddy_current_drag_;
  double drag_;
  double load_viscous_;
  CouplingTorque coupling_;
  LoadTorque load_;
  EndStopTorque stops_;
  double speed_ = 0.0;
  double load_speed_ = 0.0;
  double twist_ = 0.0;
  double start_angle_ = 0.0;  // of the load since power-on
  Grip grip_{};
  Grip load_grip_{};
  double active_inverse_ = 0.0;  // 0 while the mass is stuck
  double load_active_inverse_ = 0.0;
};

}  // namespace motor
