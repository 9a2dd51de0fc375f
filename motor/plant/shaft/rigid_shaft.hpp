#pragma once

#include <algorithm>
#include <cstddef>

#include "motor/data/load.hpp"
#include "motor/data/machine_data.hpp"
#include "motor/data/plant_data.hpp"
#include "motor/math/runge_kutta.hpp"
#include "motor/plant/shaft/friction.hpp"
#include "motor/plant/shaft/load_torque.hpp"
#include "motor/plant/shaft/step_start.hpp"

namespace motor {

/// Rotor and load as one mass. @p Plain: nothing hangs on it but a constant torque, and no wall is near.
template <bool Plain, class Number = double>
class RigidShaft {
 public:
  static constexpr bool kPlain = Plain;
  /// Numbers that a step changes; they come first.
  static constexpr std::size_t kChanging = Plain ? 7 : 14;

  struct Rate;
  /// Angle turned since the start of the step (rad), and speed (rad/s).
  struct ShaftState {
    Number angle = 0.0;
    Number speed = 0.0;

    ShaftState moved(const Rate& rate, const Number& h) const noexcept {
      return {angle + h * rate.speed, speed + h * rate.acceleration};
    }
  };
  struct Rate {
    Number speed;         ///< (rad/s)
    Number acceleration;  ///< (rad/s²)
    Number load;          ///< power into the load (W), unless Plain
    Number damping;       ///< power lost in the end stops (W), unless Plain

    static Rate summed(const Rate& a, const Rate& b, const Rate& c, const Rate& d) noexcept {
      return {stage_sum(a.speed, b.speed, c.speed, d.speed),
              stage_sum(a.acceleration, b.acceleration, c.acceleration, d.acceleration),
              stage_sum(a.load, b.load, c.load, d.load), stage_sum(a.damping, b.damping, c.damping, d.damping)};
    }
    friend Rate select(const Condition<Number>& condition, const Rate& a, const Rate& b) noexcept {
      return {motor::select(condition, a.speed, b.speed), motor::select(condition, a.acceleration, b.acceleration),
              motor::select(condition, a.load, b.load), motor::select(condition, a.damping, b.damping)};
    }
  };

  RigidShaft() = default;
  RigidShaft(const MachineData& machine, const Load& load) noexcept
      : load_{load},
        stops_{load.end_stops},
        inertia_{machine.inertia + load.inertia},
        inverse_inertia_{1.0 / inertia_},
        friction_{with_bearings(load_friction(load), machine)},
        own_friction_{friction_.coulomb},
        set_friction_{load.friction_torque},
        hysteresis_{machine.hysteresis_torque},
        viscous_{machine.viscous_friction + load.viscous_friction},
        eddy_current_drag_{machine.eddy_current_drag},
        drag_{viscous_ + eddy_current_drag_} {}

  ShaftState state() const noexcept { return {0.0, speed_}; }
  Number speed() const noexcept { return speed_; }
  /// Whether anything on it stands, so that the torque at the start of a step counts.
  Condition<Number> stands() const noexcept { return speed_ == 0.0; }
  Number load_speed() const noexcept { return speed_; }
  Number twist() const noexcept { return 0.0; }
  /// What hangs on the load (N·m) where the last step began.
  double load_torque() const noexcept { return load_.at(speed_, 0.0, 0.0); }
  void set_speed(double speed) noexcept { speed_ = speed; }
  /// Whether anything turns faster than @p limit (rad/s) after a step in which the rotor made @p rotor.
  Condition<Number> is_beyond(const MotionOf<Number>& rotor, const Number& limit) const noexcept {
    return abs(rotor.speed) > limit;
  }
  /// Takes away what turns faster than @p limit (rad/s); the energy that goes with it (J).
  Number slow_down(const Number& limit) noexcept {
    const Number before = kinetic();
    speed_ = bounded<Number>(speed_, -limit, limit);
    return before - kinetic();
  }
  /// Replaces constant load torque and friction torque (N·m).
  void set_load(double constant, double friction) noexcept {
    load_.set_constant(constant);
    set_friction_ = friction;
    sum_friction();
  }
  /// Inertia and friction become those of @p machine with @p load; the torques that were set stay.
  void set_body(const MachineData& machine, const Load& load) noexcept {
    inertia_ = machine.inertia + load.inertia;
    inverse_inertia_ = 1.0 / inertia_;
    friction_ = with_bearings(load_friction(load), machine);
    own_friction_ = friction_.coulomb;
    viscous_ = machine.viscous_friction + load.viscous_friction;
    drag_ = viscous_ + eddy_current_drag_;
    sum_friction();
  }
  /// Friction of the brake on the rotor (N·m), 0 = open.
  void set_brake(double torque) noexcept {
    brake_ = torque;
    sum_friction();
  }

  /// Decides for the coming step whether the mass holds fast against @p torque of the machine (N·m).
  [[gnu::always_inline]] void begin(const StepStartOf<Number>& start, const Number& torque) noexcept {
    if constexpr (Plain) {
      // What has been decided for a mass that turns holds as long as it does.
      const Condition<Number> holds = friction_.excess <= 0.0 && speed_ * grip_.direction > 0.0;
      if (all(holds)) return;
      grip_ = select(holds, grip_, decide(torque));
    } else {
      load_.begin(start.profile, start.angle);
      start_angle_ = start.angle;
      grip_ = decide(torque);
    }
    active_inverse_ = select<Number>(grip_.stuck.holds(), 0.0, inverse_inertia_);
    resistance_ = Plain ? Number{grip_.torque + load_.constant()} : grip_.torque;
  }
  [[gnu::always_inline]] Rate rate(const ShaftState& z, const Number& torque, const Number& time) const noexcept {
    const Number free = torque - (resistance_ + drag_ * z.speed);
    if constexpr (Plain) {
      return {z.speed, free * active_inverse_, 0.0, 0.0};
    } else {
      const Outside out = outside(z, time);
      return {z.speed, (free - out.total()) * active_inverse_, out.load * z.speed,
              (out.stop.total - out.stop.spring) * z.speed};
    }
  }
  /// Takes over the step of @p h (s) that was made with the summed rates @p sum, and says where its energy went.
  [[gnu::always_inline]] MotionOf<Number> finish(const Rate& sum, const Number& h,
                                                 PlantEnergiesOf<Number>& energies) noexcept {
    const Number weight = stage_weight(h);
    const Number angle = weight * sum.speed;
    const Number gain = weight * sum.acceleration;
    const MotionOf<Number> motion =
        settled(grip_, speed_, {speed_ + gain, angle, grip_.direction * angle}, inverse_inertia_, h);
    // Square of the speed over time, with the speed as a line: it changes by little in a step.
    const Number square = angle * (speed_ + 0.5 * gain) + h * (1.0 / 12.0) * gain * gain;
    speed_ = motion.speed;
    const Number dry = grip_.torque * grip_.direction - hysteresis_;
    energies.friction =
        dry * motion.path + viscous_ * square + (Plain ? Number{0.0} : Number{weight * sum.damping});
    energies.iron = hysteresis_ * motion.path + eddy_current_drag_ * square;
    energies.load = Plain ? Number{load_.constant() * motion.angle} : Number{weight * sum.load};
    return motion;
  }
  Number kinetic() const noexcept { return 0.5 * inertia_ * speed_ * speed_; }
  /// Energy in the springs with the rotor at @p angle (rad since power-on).
  double spring(double angle) const noexcept { return stops_.stored(angle); }
  /// Whether it stands, and stays so without torque of the machine while the load stays as it is, with the rotor
  /// at
  /// @p angle (rad since power-on).
  bool rests(double angle) const noexcept {
    if (speed_ != 0.0) return false;
    LoadTorqueOf<Number> here = load_;
    here.turn_to(angle);
    return std::abs(here.at(0.0, 0.0, 0.0) + stops_.at(angle, 0.0).total) <= friction_.holding() + hysteresis_;
  }

 private:
  /// The friction has changed; whether the mass holds fast is to be decided anew.
  void sum_friction() noexcept {
    friction_.coulomb = own_friction_ + set_friction_ + brake_;
    grip_ = {};
  }
  /// Torques from outside (N·m, against positive rotation).
  struct Outside {
    Number load = 0.0;
    typename EndStopTorqueOf<Number>::Push stop{};

    Number total() const noexcept { return Plain ? load : Number{load + stop.total}; }
  };
  Outside outside(const ShaftState& z, const Number& time) const noexcept {
    if constexpr (Plain) return {load_.constant()};
    Outside result{load_.at(z.speed, z.angle, time)};
    if (stops_.present()) result.stop = stops_.at(start_angle_ + z.angle, z.speed);
    return result;
  }
  GripOf<Number> decide(const Number& torque) const noexcept {
    return GripOf<Number>::decide(friction_, hysteresis_, speed_, torque - outside(state(), 0.0).total());
  }

  // What a step changes;
  Number speed_ = 0.0;
  Number start_angle_ = 0.0;
  GripOf<Number> grip_{};
  Number resistance_ = 0.0;      // what is constant in a step (N·m)
  Number active_inverse_ = 0.0;  // 0 while the mass is stuck
  LoadTorqueOf<Number> load_{};
  // and what it does not.
  EndStopTorqueOf<Number> stops_{};
  Number inertia_ = 1.0;
  Number inverse_inertia_ = 1.0;
  DryFrictionOf<Number> friction_{};
  Number own_friction_ = 0.0;  // of friction_.coulomb: bearings and load
  Number set_friction_ = 0.0;
  Number brake_ = 0.0;
  Number hysteresis_ = 0.0;
  Number viscous_ = 0.0;
  Number eddy_current_drag_ = 0.0;
  Number drag_ = 0.0;
};

}  // namespace motor
