#include "device/process_data.hpp"

#include "device/object_index.hpp"

namespace device {

ProcessData::ProcessData(canopen::Dictionary& dictionary, const drive::BusScaling& scaling)
    : scaling_{scaling},
      controlword_{dictionary.cell<std::uint16_t>(object::kControlword, 0)},
      target_velocity_{dictionary.cell<std::int32_t>(object::kTargetVelocity, 0)},
      target_torque_{dictionary.cell<std::int16_t>(object::kTargetTorque, 0)},
      statusword_{dictionary.cell<std::uint16_t>(object::kStatusword, 0)},
      mode_display_{dictionary.cell<std::int8_t>(object::kModesOfOperationDisplay, 0)},
      position_actual_{dictionary.cell<std::int32_t>(object::kPositionActual, 0)},
      velocity_demand_{dictionary.cell<std::int32_t>(object::kVelocityDemand, 0)},
      velocity_actual_{dictionary.cell<std::int32_t>(object::kVelocityActual, 0)},
      torque_demand_{dictionary.cell<std::int16_t>(object::kTorqueDemand, 0)},
      torque_actual_{dictionary.cell<std::int16_t>(object::kTorqueActual, 0)} {}

drive::Setpoints ProcessData::setpoints() const noexcept {
  return {.controlword = controlword_.get(),
          .speed = scaling_.speed_from_bus(target_velocity_.get()),
          .torque = scaling_.torque_from_bus(target_torque_.get())};
}

void ProcessData::publish(const drive::ActualValues& actual) noexcept {
  statusword_.set(actual.statusword);
  mode_display_.set(static_cast<std::int8_t>(actual.mode));
  position_actual_.set(actual.encoder_position);
  velocity_demand_.set(scaling_.speed_to_bus(actual.speed_demand));
  velocity_actual_.set(scaling_.speed_to_bus(actual.speed));
  torque_demand_.set(scaling_.torque_to_bus(actual.torque_demand));
  torque_actual_.set(scaling_.torque_to_bus(actual.torque));
}

}  // namespace device
