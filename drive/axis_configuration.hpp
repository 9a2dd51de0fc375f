#pragma once

#include "drive/object_kind.hpp"
#include "motor/inverter_data.hpp"
#include "motor/load.hpp"
#include "motor/machine_data.hpp"

namespace drive {

/// The machine of an axis, what it turns, the power unit that feeds it, and the control that drives it.
struct AxisConfiguration {
  motor::MachineData machine{};
  motor::Load load{};
  ObjectKind kind = ObjectKind::Servo;  ///< Servo or Vector
  motor::InverterData inverter{};
};

}  // namespace drive
