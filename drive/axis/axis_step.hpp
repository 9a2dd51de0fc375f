#pragma once

#include "drive/axis/axis.hpp"

// A step of 125 µs, to be compiled into the loops that make it.
namespace drive {

inline double Axis::step(double dc_voltage) noexcept {
  if (measured_) [[unlikely]]
    return measured_step(dc_voltage);
  if (command_.pulses_enabled) {
    auto& channel = block<SetpointChannel>();
    command_.speed_setpoint = channel.step(motor::kControlPeriod);
    command_.acceleration_setpoint = channel.acceleration();
  }
  return move(dc_voltage);
}

[[gnu::always_inline]] inline double Axis::move(double dc_voltage) noexcept {
  const double drawn = train_.step(dc_voltage, command_);
  const motor::Signals& seen = train_.signals();
  block<Measurement>().add(seen);
  if (!block<PowerUnit>().watch(dc_voltage, seen, train_.plant_state().current)) [[unlikely]]
    command_.pulses_enabled = false;
  return drawn;
}

}  // namespace drive
