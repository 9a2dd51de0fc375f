#include "drive/speed_control/speed_control.hpp"

#include <algorithm>
#include <array>

#include "motor/control/field/tuning.hpp"

namespace drive {
namespace {

using motor::ControlMode;

/// p1300 from each number on.
struct ControlModeRow {
  std::int32_t from;
  ControlMode mode;
};
constexpr std::array kControlModes{
    ControlModeRow{23, ControlMode::Encoder}, ControlModeRow{22, ControlMode::Sensorless},
    ControlModeRow{21, ControlMode::Encoder}, ControlModeRow{20, ControlMode::Sensorless},
    ControlModeRow{0, ControlMode::VoltageFrequency}};
constexpr std::int32_t kParabolic = 2;

ControlMode control_of(std::int32_t number) noexcept {
  return std::ranges::find_if(kControlModes, [=](const ControlModeRow& row) { return number >= row.from; })->mode;
}

}  // namespace

motor::ControlSettings SpeedControl::control_settings(const motor::MachineData& machine, const MotorModel& model,
                                                      const motor::InverterData& inverter,
                                                      std::optional<double> highest_dc_voltage) const noexcept {
  const Settings& p = settings;
  motor::ControlSettings set = motor::computed_settings(machine, inverter, model.total_inertia());
  set.mode = control_of(p.control_mode);
  set.speed = {p.speed_gain, p.speed_integral_time};
  set.sensorless_speed = {p.encoderless_speed_gain, p.encoderless_speed_integral_time};
  set.current_limit = std::min(p.current_limit, inverter.maximum_current);
  if (model.settings.motor_limit_current > 0.0)
    set.current_limit = std::min(set.current_limit, model.settings.motor_limit_current);
  set.motoring_power_limit = p.motoring_power_limit;
  set.regenerative_power_limit = p.regenerative_power_limit;
  set.acceleration_precontrol = p.acceleration_precontrol;
  set.speed_smoothing = p.speed_smoothing;
  set.voltage_frequency.parabolic = p.control_mode == kParabolic;
  if (highest_dc_voltage) set.vdc_max = *highest_dc_voltage;
  return set;
}

}  // namespace drive
