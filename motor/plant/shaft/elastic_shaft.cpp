#include "motor/plant/shaft/elastic_shaft.hpp"

#include <cmath>

namespace motor {

template <>
ElasticShaft::ElasticShaftOf(const MachineData& machine, const Load& load) noexcept
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

template <>
void ElasticShaft::set_body(const MachineData&, const Load& load) noexcept {
  const double set_friction = load_friction_.coulomb - own_load_friction_;
  load_inertia_ = load.inertia;
  load_inverse_inertia_ = 1.0 / load_inertia_;
  load_friction_ = load_friction(load);
  own_load_friction_ = load_friction_.coulomb;
  load_friction_.coulomb += set_friction;
  load_viscous_ = load.viscous_friction;
}

template <>
bool ElasticShaft::rests(double angle) const noexcept {
  if (speed_ != 0.0 || load_speed_ != 0.0) return false;
  LoadTorque here = load_;
  here.turn_to(angle - twist_);
  const double shaft = coupling_.at(twist_, 0.0).total;
  const double outside = here.at(0.0, 0.0, 0.0) + stops_.at(angle - twist_, 0.0).total;
  return std::abs(shaft) <= friction_.holding() + hysteresis_ &&
         std::abs(shaft - outside) <= load_friction_.holding();
}

}  // namespace motor
