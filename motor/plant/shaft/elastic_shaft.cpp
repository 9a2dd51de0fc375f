#include "motor/plant/shaft/elastic_shaft.hpp"

#include <algorithm>
#include <cmath>

namespace motor {

ElasticShaft::ElasticShaft(const MachineData& machine, const Load& load) noexcept
    : inertia_{machine.inertia},
      inverse_inertia_{1.0 / inertia_},
      load_inertia_{load.inertia},
      load_inverse_inertia_{1.0 / load_inertia_},
      friction_{machine.coulomb_friction, 0.0, load.stribeck_speed},
      open_friction_{friction_.coulomb},
      load_friction_{load_friction(load)},
      own_load_friction_{load_friction_.coulomb},
      hysteresis_{machine.hysteresis_torque},
      viscous_{machine.viscous_friction},
      eddy_current_drag_{machine.eddy_current_drag},
      drag_{viscous_ + eddy_current_drag_},
      load_viscous_{load.viscous_friction},
      coupling_{load.coupling},
      load_{load},
      stops_{load.end_stops} {
  load_friction_.coulomb += load.friction_torque;
}

void ElasticShaft::set_body(const MachineData&, const Load& load) noexcept {
  const double set_friction = load_friction_.coulomb - own_load_friction_;
  load_inertia_ = load.inertia;
  load_inverse_inertia_ = 1.0 / load_inertia_;
  load_friction_ = load_friction(load);
  own_load_friction_ = load_friction_.coulomb;
  load_friction_.coulomb += set_friction;
  load_viscous_ = load.viscous_friction;
}

void ElasticShaft::begin(const StepStart& start, double torque) noexcept {
  start_angle_ = start.angle - twist_;
  load_.begin(start.time, start_angle_);
  const ShaftState z = state();
  const double shaft = coupling_.at(twist_, speed_ - load_speed_).total;
  const double outside = load_.at(load_speed_, 0.0, 0.0) + stop_at(z).total;
  grip_ = Grip::decide(friction_, hysteresis_, speed_, torque - shaft);
  load_grip_ = Grip::decide(load_friction_, 0.0, load_speed_, shaft - outside);
  active_inverse_ = grip_.stuck ? 0.0 : inverse_inertia_;
  load_active_inverse_ = load_grip_.stuck ? 0.0 : load_inverse_inertia_;
}

Motion ElasticShaft::finish(const Rate& sum, double h, PlantEnergies& energies) noexcept {
  const double weight = stage_weight(h);
  const double angle = weight * sum.speed;
  const double load_angle = weight * sum.load_speed;
  const Motion rotor = settled(grip_, speed_, {speed_ + weight * sum.acceleration, angle, grip_.direction * angle},
                               inverse_inertia_, h);
  const Motion load =
      settled(load_grip_, load_speed_,
              {load_speed_ + weight * sum.load_acceleration, load_angle, load_grip_.direction * load_angle},
              load_inverse_inertia_, h);
  speed_ = rotor.speed;
  load_speed_ = load.speed;
  twist_ += rotor.angle - load.angle;
  const double dry = grip_.torque * grip_.direction - hysteresis_;
  energies.friction = dry * rotor.path + load_grip_.torque * load_grip_.direction * load.path +
                      weight * (viscous_ * sum.square + load_viscous_ * sum.load_square + sum.damping);
  energies.iron = hysteresis_ * rotor.path + weight * eddy_current_drag_ * sum.square;
  energies.load = weight * sum.load;
  return rotor;
}

double ElasticShaft::slow_down(double limit) noexcept {
  const double before = kinetic();
  speed_ = std::clamp(speed_, -limit, limit);
  load_speed_ = std::clamp(load_speed_, -limit, limit);
  return before - kinetic();
}

double ElasticShaft::kinetic() const noexcept {
  return 0.5 * (inertia_ * speed_ * speed_ + load_inertia_ * load_speed_ * load_speed_);
}

bool ElasticShaft::rests(double angle) const noexcept {
  if (speed_ != 0.0 || load_speed_ != 0.0 || !load_.settled()) return false;
  LoadTorque here = load_;
  here.turn_to(angle - twist_);
  const double shaft = coupling_.at(twist_, 0.0).total;
  const double outside = here.at(0.0, 0.0, 0.0) + stops_.at(angle - twist_, 0.0).total;
  return std::abs(shaft) <= friction_.holding() + hysteresis_ &&
         std::abs(shaft - outside) <= load_friction_.holding();
}

}  // namespace motor
