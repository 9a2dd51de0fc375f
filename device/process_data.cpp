#include "device/process_data.hpp"

#include "device/object_index.hpp"
#include "drive/units.hpp"

namespace device {
namespace {

template <class Value>
canopen::Cell<Value> cell(canopen::Dictionary& dictionary, std::uint16_t index, std::size_t axis) {
  return dictionary.cell<Value>(object::on_axis(index, axis), 0);
}

}  // namespace

ProcessData::ProcessData(canopen::Dictionary& dictionary, std::size_t axis, const drive::BusScaling& scaling)
    : scaling_{scaling},
      controlword_{cell<std::uint16_t>(dictionary, object::kControlword, axis)},
      target_velocity_{cell<std::int32_t>(dictionary, object::kTargetVelocity, axis)},
      target_torque_{cell<std::int16_t>(dictionary, object::kTargetTorque, axis)},
      statusword_{cell<std::uint16_t>(dictionary, object::kStatusword, axis)},
      mode_display_{cell<std::int8_t>(dictionary, object::kModesOfOperationDisplay, axis)},
      position_actual_{cell<std::int32_t>(dictionary, object::kPositionActual, axis)},
      vl_velocity_demand_{cell<std::int16_t>(dictionary, object::kVlVelocityDemand, axis)},
      vl_velocity_actual_{cell<std::int16_t>(dictionary, object::kVlVelocityActual, axis)},
      velocity_sensor_actual_{cell<std::int32_t>(dictionary, object::kVelocitySensorActual, axis)},
      velocity_demand_{cell<std::int32_t>(dictionary, object::kVelocityDemand, axis)},
      velocity_actual_{cell<std::int32_t>(dictionary, object::kVelocityActual, axis)},
      torque_demand_{cell<std::int16_t>(dictionary, object::kTorqueDemand, axis)},
      torque_actual_{cell<std::int16_t>(dictionary, object::kTorqueActual, axis)} {}

drive::Setpoints ProcessData::setpoints() const noexcept {
  return {.controlword = controlword_.get(),
          .speed = scaling_.speed_from_bus(target_velocity_.get()),
          .torque = scaling_.torque_from_bus(target_torque_.get())};
}

void ProcessData::publish(const drive::ActualValues& actual) noexcept {
  statusword_.set(actual.statusword);
  mode_display_.set(static_cast<std::int8_t>(actual.mode));
  position_actual_.set(actual.encoder_position);
  vl_velocity_demand_.set(drive::saturated<std::int16_t>(actual.speed_demand / drive::kRpm));
  vl_velocity_actual_.set(drive::saturated<std::int16_t>(actual.speed / drive::kRpm));
  velocity_sensor_actual_.set(scaling_.speed_to_bus(actual.speed));
  velocity_demand_.set(scaling_.speed_to_bus(actual.speed_demand));
  velocity_actual_.set(scaling_.speed_to_bus(actual.speed));
  torque_demand_.set(scaling_.torque_to_bus(actual.torque_demand));
  torque_actual_.set(scaling_.torque_to_bus(actual.torque));
}

}  // namespace device
