#pragma once

#include <algorithm>

#include "motor/data/load.hpp"
#include "motor/data/machine_data.hpp"
#include "motor/data/plant_data.hpp"
#include "motor/math/runge_kutta.hpp"
#include "motor/plant/shaft/friction.hpp"
#include "motor/plant/shaft/load_torque.hpp"
#include "motor/plant/shaft/step_start.hpp"

namespace motor {

/// Rotor and load as one mass. @p Plain: nothing hangs on it but a constant torque, and no wall is near.
template <bool Plain>
class RigidShaft {
 public:
  static constexpr bool kPlain = Plain;

  struct Rate;
  /// Angle turned since the start of the step (rad), and speed (rad/s).
  struct ShaftState {
    double angle = 0.0;
    double speed = 0.0;

    ShaftState moved(const Rate& rate, double h) const noexcept {
      return {angle + h * rate.speed, speed + h * rate.acceleration};
    }
  };
  struct Rate {
    double speed;         ///< (rad/s)
    double acceleration;  ///< (rad/s²)
    double load;          ///< power into the load (W), unless Plain
    double damping;       ///< power lost in the end stops (W), unless Plain

    static Rate summed(const Rate& a, const Rate& b, const Rate& c, const Rate& d) noexcept {
      return {stage_sum(a.speed, b.speed, c.speed, d.speed),
              stage_sum(a.acceleration, b.acceleration, c.acceleration, d.acceleration),
              stage_sum(a.load, b.load, c.load, d.load), stage_sum(a.damping, b.damping, c.damping, d.damping)};
    }
  };

  RigidShaft(const MachineData& machine, const Load& load) noexcept
      : inertia_{machine.inertia + load.inertia},
        inverse_inertia_{1.0 / inertia_},
        friction_{with_bearings(load_friction(load), machine)},
        own_friction_{friction_.coulomb},
        set_friction_{load.friction_torque},
        hysteresis_{machine.hysteresis_torque},
        viscous_{machine.viscous_friction + load.viscous_friction},
        eddy_current_drag_{machine.eddy_current_drag},
        drag_{viscous_ + eddy_current_drag_},
        load_{load},
        stops_{load.end_stops} {}

  /// Whether nothing but a constant torque hangs on it.
  bool is_plain() const noexcept { return !load_.varies() && !stops_.present(); }
  ShaftState state() const noexcept { return {0.0, speed_}; }
  double speed() const noexcept { return speed_; }
  /// Whether anything on it stands, so that the torque at the start of a step counts.
  bool stands() const noexcept { return speed_ == 0.0; }
  double load_speed() const noexcept { return speed_; }
  double twist() const noexcept { return 0.0; }
  /// What hangs on the load (N·m) where the last step began.
  double load_torque() const noexcept { return load_.at(speed_, 0.0, 0.0); }
  void set_speed(double speed) noexcept { speed_ = speed; }
  /// Whether anything turns faster than @p limit (rad/s) after a step in which the rotor made @p rotor.
  bool is_beyond(const Motion& rotor, double limit) const noexcept { return std::abs(rotor.speed) > limit; }
  /// Takes away what turns faster than @p limit (rad/s); the energy that goes with it (J).
  double slow_down(double limit) noexcept {
    const double before = kinetic();
    speed_ = std::clamp(speed_, -limit, limit);
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
  void begin(const StepStart& start, double torque) noexcept {
    if constexpr (Plain) {
      // What has been decided for a mass that turns holds as long as it does.
      if (friction_.excess <= 0.0 && speed_ * grip_.direction > 0.0) return;
    } else {
      load_.begin(start.time, start.angle);
      start_angle_ = start.angle;
    }
    grip_ = Grip::decide(friction_, hysteresis_, speed_, torque - outside(state(), 0.0).total());
    active_inverse_ = grip_.stuck ? 0.0 : inverse_inertia_;
    resistance_ = Plain ? grip_.torque + load_.constant() : grip_.torque;
  }
  Rate rate(const ShaftState& z, double torque, double time) const noexcept {
    const double free = torque - (resistance_ + drag_ * z.speed);
    if constexpr (Plain) {
      return {z.speed, free * active_inverse_, 0.0, 0.0};
    } else {
      const Outside out = outside(z, time);
      return {z.speed, (free - out.total()) * active_inverse_, out.load * z.speed,
              (out.stop.total - out.stop.spring) * z.speed};
    }
  }
  /// Takes over the step of @p h (s) that was made with the summed rates @p sum, and says where its energy went.
  [[gnu::always_inline]] Motion finish(const Rate& sum, double h, PlantEnergies& energies) noexcept {
    const double weight = stage_weight(h);
    const double angle = weight * sum.speed;
    const double gain = weight * sum.acceleration;
    const Motion motion =
        settled(grip_, speed_, {speed_ + gain, angle, grip_.direction * angle}, inverse_inertia_, h);
    // Square of the speed over time, with the speed as a line: it changes by little in a step.
    const double square = angle * (speed_ + 0.5 * gain) + h * (1.0 / 12.0) * gain * gain;
    speed_ = motion.speed;
    const double dry = grip_.torque * grip_.direction - hysteresis_;
    energies.friction = dry * motion.path + viscous_ * square + (Plain ? 0.0 : weight * sum.damping);
    energies.iron = hysteresis_ * motion.path + eddy_current_drag_ * square;
    energies.load = Plain ? load_.constant() * motion.angle : weight * sum.load;
    return motion;
  }
  double kinetic() const noexcept { return 0.5 * inertia_ * speed_ * speed_; }
  /// Energy in the springs with the rotor at @p angle (rad since power-on).
  double spring(double angle) const noexcept { return stops_.stored(angle); }
  /// Whether it stands, and stays so without torque of the machine, with the rotor at @p angle (rad since
  /// power-on).
  bool rests(double angle) const noexcept {
    if (speed_ != 0.0 || !load_.settled()) return false;
    LoadTorque here = load_;
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
    double load = 0.0;
    EndStopTorque::Push stop{};

    double total() const noexcept { return Plain ? load : load + stop.total; }
  };
  Outside outside(const ShaftState& z, double time) const noexcept {
    if constexpr (Plain) return {load_.constant()};
    return {load_.at(z.speed, z.angle, time),
            stops_.present() ? stops_.at(start_angle_ + z.angle, z.speed) : EndStopTorque::Push{}};
  }

  double inertia_;
  double inverse_inertia_;
  DryFriction friction_;
  double own_friction_;  // of friction_.coulomb: bearings and load
  double set_friction_;
  double brake_ = 0.0;
  double hysteresis_;
  double viscous_;
  double eddy_current_drag_;
  double drag_;
  LoadTorque load_;
  EndStopTorque stops_;
  double speed_ = 0.0;
  double start_angle_ = 0.0;
  Grip grip_{};
  double resistance_ = 0.0;      // what is constant in a step (N·m)
  double active_inverse_ = 0.0;  // 0 while the mass is stuck
};

}  // namespace motor
