#pragma once

#include "drive/base/load_mechanics.hpp"
#include "drive/base/object_kind.hpp"
#include "motor/data/inverter_data.hpp"
#include "motor/data/load.hpp"
#include "motor/data/machine_data.hpp"
#include "motor/data/plant_deviation.hpp"

namespace drive {

/// The machine of an axis, what it turns, the power unit that feeds it, and the control that drives it.
struct AxisConfiguration {
  motor::MachineData machine{};  ///< by its data sheet
  motor::Load load{};
  ObjectKind kind = ObjectKind::Servo;  ///< Servo or Vector
  motor::InverterData inverter{};
  motor::PlantDeviation deviation{};  ///< of what turns from the data sheet
  bool setpoint_channel =
      true;  ///< p0108.8 of a new unit, the extended setpoint channel; a vector axis has it always
  LoadMechanics mechanics{};    ///< the gear that is in `load` already, and what a revolution behind it is
  TravelSwitchList switches{};  ///< beside the way of the load
  bool positioner = false;      ///< p0108.3 and p0108.4, position control and basic positioner
};

}  // namespace drive
