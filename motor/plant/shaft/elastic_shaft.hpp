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
template <class Number>
class CouplingTorqueOf {
 public:
  /// What acts on the load (N·m): what the spring holds, and with the damper.
  struct Push {
    Number spring = 0.0;
    Number total = 0.0;
  };

  explicit CouplingTorqueOf(const Coupling& coupling) noexcept
      : stiffness_{coupling.stiffness}, damping_{coupling.damping}, play_{0.5 * coupling.backlash} {}
  CouplingTorqueOf() = default;

  /// At @p twist (rad) and its change (rad/s).
  Push at(const Number& twist, const Number& change) const noexcept {
    const Condition<Number> tight = play_ <= 0.0;
    const Number straight = stiffness_ * twist;
    const Number damped = straight + damping_ * change;
    if (all(tight)) return {straight, damped};
    const Number bent = beyond_play(twist);
    const Number spring = stiffness_ * bent;
    const Number total = spring + damping_ * change;
    return {select<Number>(tight, straight, spring),
            select<Number>(tight, damped, select<Number>(total * bent > 0.0, total, 0.0))};
  }
  /// Energy in the spring (J).
  Number stored(const Number& twist) const noexcept {
    const Number bent = beyond_play(twist);
    return 0.5 * stiffness_ * bent * bent;
  }

 private:
  Number beyond_play(const Number& twist) const noexcept {
    return select<Number>(twist > play_, twist - play_, select<Number>(twist < -play_, twist + play_, 0.0));
  }

  Number stiffness_ = 0.0;
  Number damping_ = 0.0;
  Number play_ = 0.0;
};

using CouplingTorque = CouplingTorqueOf<double>;

/// Rotor and load as two masses; each has its own friction.
template <class Number>
class ElasticShaftOf {
 public:
  static constexpr bool kPlain = false;
  /// Numbers of which a step changes some.
  static constexpr std::size_t kChanging = 44;

  struct Rate;
  /// Angles turned since the start of the step (rad), and speeds (rad/s).
  struct ShaftState {
    Number angle = 0.0;
    Number speed = 0.0;
    Number load_angle = 0.0;
    Number load_speed = 0.0;

    ShaftState moved(const Rate& rate, const Number& h) const noexcept {
      return {angle + h * rate.speed, speed + h * rate.acceleration, load_angle + h * rate.load_speed,
              load_speed + h * rate.load_acceleration};
    }
  };
  struct Rate {
    Number speed;              ///< (rad/s)
    Number acceleration;       ///< (rad/s²)
    Number load_speed;         ///< (rad/s)
    Number load_acceleration;  ///< (rad/s²)
    Number square;             ///< of the rotor's speed (rad²/s²)
    Number load_square;        ///< of the load's speed (rad²/s²)
    Number load;               ///< power into the load (W)
    Number damping;            ///< power lost in coupling and end stops (W)

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
    friend Rate select(const Condition<Number>& condition, const Rate& a, const Rate& b) noexcept {
      return {motor::select(condition, a.speed, b.speed),
              motor::select(condition, a.acceleration, b.acceleration),
              motor::select(condition, a.load_speed, b.load_speed),
              motor::select(condition, a.load_acceleration, b.load_acceleration),
              motor::select(condition, a.square, b.square),
              motor::select(condition, a.load_square, b.load_square),
              motor::select(condition, a.load, b.load),
              motor::select(condition, a.damping, b.damping)};
    }
  };

  ElasticShaftOf() = default;
  ElasticShaftOf(const MachineData& machine, const Load& load) noexcept;

  ShaftState state() const noexcept { return {0.0, speed_, 0.0, load_speed_}; }
  Number speed() const noexcept { return speed_; }
  /// Whether anything on it stands, so that the torque at the start of a step counts.
  Condition<Number> stands() const noexcept { return speed_ == 0.0; }
  Number load_speed() const noexcept { return load_speed_; }
  Number twist() const noexcept { return twist_; }
  /// What hangs on the load (N·m) where the last step began.
  double load_torque() const noexcept { return load_.at(load_speed_, 0.0, 0.0); }
  void set_speed(double speed) noexcept { speed_ = load_speed_ = speed; }
  /// Whether anything turns faster than @p limit (rad/s) after a step in which the rotor made @p rotor.
  Condition<Number> is_beyond(const MotionOf<Number>& rotor, const Number& limit) const noexcept {
    return abs(rotor.speed) > limit || abs(load_speed_) > limit;
  }
  /// Takes away what turns faster than @p limit (rad/s); the energy that goes with it (J).
  Number slow_down(const Number& limit) noexcept {
    const Number before = kinetic();
    speed_ = bounded<Number>(speed_, -limit, limit);
    load_speed_ = bounded<Number>(load_speed_, -limit, limit);
    return before - kinetic();
  }
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
  void begin(const StepStartOf<Number>& start, const Number& torque) noexcept {
    start_angle_ = start.angle - twist_;
    load_.begin(start.profile, start_angle_);
    const ShaftState z = state();
    const Number shaft = coupling_.at(twist_, speed_ - load_speed_).total;
    const Number outside = load_.at(load_speed_, 0.0, 0.0) + stop_at(z).total;
    grip_ = GripOf<Number>::decide(friction_, hysteresis_, speed_, torque - shaft);
    load_grip_ = GripOf<Number>::decide(load_friction_, 0.0, load_speed_, shaft - outside);
    active_inverse_ = select<Number>(grip_.stuck.holds(), 0.0, inverse_inertia_);
    load_active_inverse_ = select<Number>(load_grip_.stuck.holds(), 0.0, load_inverse_inertia_);
  }
  Rate rate(const ShaftState& z, const Number& torque, const Number& time) const noexcept {
    const Number change = z.speed - z.load_speed;
    const typename CouplingTorqueOf<Number>::Push shaft = coupling_.at(twist_ + z.angle - z.load_angle, change);
    const typename EndStopTorqueOf<Number>::Push stop = stop_at(z);
    const Number load = load_.at(z.load_speed, z.load_angle, time);
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
  MotionOf<Number> finish(const Rate& sum, const Number& h, PlantEnergiesOf<Number>& energies) noexcept;
  Number kinetic() const noexcept {
    return 0.5 * (inertia_ * speed_ * speed_ + load_inertia_ * load_speed_ * load_speed_);
  }
  /// Energy in the springs with the rotor at @p angle (rad since power-on).
  double spring(double angle) const noexcept { return coupling_.stored(twist_) + stops_.stored(angle - twist_); }
  /// Whether both stand, and stay so without torque of the machine, with the rotor at @p angle (rad since
  /// power-on).
  bool rests(double angle) const noexcept;

 private:
  typename EndStopTorqueOf<Number>::Push stop_at(const ShaftState& z) const noexcept {
    if (!stops_.present()) return {};
    return stops_.at(start_angle_ + z.load_angle, z.load_speed);
  }

  Number inertia_ = 1.0;
  Number inverse_inertia_ = 1.0;
  Number load_inertia_ = 1.0;
  Number load_inverse_inertia_ = 1.0;
  DryFrictionOf<Number> friction_{};
  Number open_friction_ = 0.0;  // of friction_.coulomb without the brake
  DryFrictionOf<Number> load_friction_{};
  Number own_load_friction_ = 0.0;  // of load_friction_.coulomb
  Number hysteresis_ = 0.0;
  Number viscous_ = 0.0;
  Number eddy_current_drag_ = 0.0;
  Number drag_ = 0.0;
  Number load_viscous_ = 0.0;
  CouplingTorqueOf<Number> coupling_{};
  LoadTorqueOf<Number> load_{};
  EndStopTorqueOf<Number> stops_{};
  Number speed_ = 0.0;
  Number load_speed_ = 0.0;
  Number twist_ = 0.0;
  Number start_angle_ = 0.0;  // of the load since power-on
  GripOf<Number> grip_{};
  GripOf<Number> load_grip_{};
  Number active_inverse_ = 0.0;  // 0 while the mass is stuck
  Number load_active_inverse_ = 0.0;
};
using ElasticShaft = ElasticShaftOf<double>;

template <>
ElasticShaft::ElasticShaftOf(const MachineData& machine, const Load& load) noexcept;
template <>
void ElasticShaft::set_body(const MachineData& machine, const Load& load) noexcept;
template <>
bool ElasticShaft::rests(double angle) const noexcept;

template <class Number>
MotionOf<Number> ElasticShaftOf<Number>::finish(const Rate& sum, const Number& h,
                                                PlantEnergiesOf<Number>& energies) noexcept {
  const Number weight = stage_weight(h);
  const Number angle = weight * sum.speed;
  const Number load_angle = weight * sum.load_speed;
  const MotionOf<Number> rotor = settled(
      grip_, speed_, {speed_ + weight * sum.acceleration, angle, grip_.direction * angle}, inverse_inertia_, h);
  const MotionOf<Number> load =
      settled(load_grip_, load_speed_,
              {load_speed_ + weight * sum.load_acceleration, load_angle, load_grip_.direction * load_angle},
              load_inverse_inertia_, h);
  speed_ = rotor.speed;
  load_speed_ = load.speed;
  twist_ += rotor.angle - load.angle;
  const Number dry = grip_.torque * grip_.direction - hysteresis_;
  energies.friction = dry * rotor.path + load_grip_.torque * load_grip_.direction * load.path +
                      weight * (viscous_ * sum.square + load_viscous_ * sum.load_square + sum.damping);
  energies.iron = hysteresis_ * rotor.path + weight * eddy_current_drag_ * sum.square;
  energies.load = weight * sum.load;
  return rotor;
}

}  // namespace motor
