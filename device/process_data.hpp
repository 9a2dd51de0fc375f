#pragma once

#include <cstdint>

#include "drive/axis.hpp"
#include "drive/scaling.hpp"
#include "libcanopen/od/dictionary.hpp"

namespace device {

/// The process data of one axis: setpoints out of the dictionary and actual values into it, in bus units on that
/// side and in SI units on the other. This is the only place where they are converted.
class ProcessData {
 public:
  /// Binds the objects of axis @p axis (1..drive::kMostAxes) in @p dictionary; @p scaling holds for the life of
  /// the axis.
  ProcessData(canopen::Dictionary& dictionary, std::size_t axis, const drive::BusScaling& scaling);

  /// What the master last asked for.
  drive::Setpoints setpoints() const noexcept;
  /// The controlword alone.
  std::uint16_t controlword() const noexcept { return controlword_.get(); }
  /// Shows @p actual to the master.
  void publish(const drive::ActualValues& actual) noexcept;

 private:
  drive::BusScaling scaling_;
  canopen::Cell<std::uint16_t> controlword_;
  canopen::Cell<std::int32_t> target_velocity_;
  canopen::Cell<std::int16_t> target_torque_;
  canopen::Cell<std::uint16_t> statusword_;
  canopen::Cell<std::int8_t> mode_display_;
  canopen::Cell<std::int32_t> position_actual_;
  canopen::Cell<std::int16_t> vl_velocity_demand_;
  canopen::Cell<std::int16_t> vl_velocity_actual_;
  canopen::Cell<std::int32_t> velocity_sensor_actual_;
  canopen::Cell<std::int32_t> velocity_demand_;
  canopen::Cell<std::int32_t> velocity_actual_;
  canopen::Cell<std::int16_t> torque_demand_;
  canopen::Cell<std::int16_t> torque_actual_;
};

}  // namespace device
