#pragma once

#include "motor/control/control_settings.hpp"
#include "motor/data/machine_data.hpp"
#include "motor/identification/model/saturation_curve.hpp"

namespace motor {

/// What a rotating measurement starts from: nothing but what the drive believes, and what it may do.
struct RotatingTask {
  MachineData machine{};
  ControlSettings settings{};
  double maximum_speed = 0.0;  ///< p1082 (rad/s), positive
  double ramp_time = -1.0;     ///< p1958, from 0 to maximum_speed (s); negative: as fast as the torque gives well
  TorqueLimits torque_limits{};  ///< p1520, p1521 (N·m)
  bool forward = true;           ///< may turn forwards
  bool backward = true;          ///< may turn backwards
  bool finds_flux = true;        ///< flux of the magnets, or saturation characteristic of an induction machine
  bool finds_inertia = true;
};

/// What it finds; 0 where nothing was asked for.
struct RotatingResult : SaturationCurve {
  double inertia = 0.0;  ///< r1969, of all that turns (kg·m²)
  double coulomb_friction =
      0.0;  ///< with what the iron loses likewise (N·m); 0 with one direction, see load_torque
  double viscous_friction = 0.0;  ///< with what the iron loses likewise (N·m·s/rad)
  /// Constant one, positive against positive rotation (N·m). Where one direction only is allowed, the dry friction
  /// cannot be told from it and is in it.
  double load_torque = 0.0;
  double magnet_flux = 0.0;        ///< of a synchronous machine, as warm as it was (V·s)
  double threshold_voltage = 0.0;  ///< what each phase loses to dead time and valves, where a flux was found (V)
  double travel = 0.0;             ///< the furthest way from the start (rad)
};

}  // namespace motor
