#include "trace/signal/quantity_table.hpp"

#include <array>
#include <cstddef>
#include <numbers>

namespace trace {
namespace {

using drive::Axis;
using drive::DriveUnit;
using drive::Unit;

using AxisRow = QuantityRow<Axis>;
using UnitRow = QuantityRow<DriveUnit>;

template <double motor::Signals::*Member>
double signal(const Axis& axis) noexcept {
  return axis.signals().*Member;
}
template <double motor::PlantState::*Member>
double state(const Axis& axis) noexcept {
  return axis.drive_train().plant_state().*Member;
}
double position(const Axis& axis) noexcept {
  const motor::PlantState& plant = axis.drive_train().plant_state();
  return static_cast<double>(plant.revolutions) * 2.0 * std::numbers::pi + plant.rotor_angle;
}
/// Current in phase @p Phase (0 = U).
template <std::size_t Phase>
double phase_current(const Axis& axis) noexcept {
  return motor::phase_values(axis.drive_train().plant_state().current)[Phase];
}

constexpr std::array kAxisRows{
    AxisRow{"speed", Unit::Rpm, &signal<&motor::Signals::true_speed>, "Speed of the motor shaft"},
    AxisRow{"measured_speed", Unit::Rpm, &signal<&motor::Signals::measured_speed>,
            "Speed from the encoder or the estimate, which the controller sees"},
    AxisRow{"speed_setpoint", Unit::Rpm,
            [](const Axis& axis) noexcept { return axis.block<drive::SetpointChannel>().total(); },
            "Speed setpoint behind the ramp-function generator"},
    AxisRow{"load_speed", Unit::Rpm, &state<&motor::PlantState::load_speed>, "Speed of the load"},
    AxisRow{"position", Unit::Degrees, &position, "Angle that the motor shaft has turned since power-on"},
    AxisRow{"rotor_angle", Unit::Degrees, &state<&motor::PlantState::rotor_angle>,
            "Angle of the motor shaft within a revolution"},
    AxisRow{"twist", Unit::Degrees, &state<&motor::PlantState::twist>, "Angle of the rotor less that of the load"},
    AxisRow{"encoder_position", Unit::Increments,
            [](const Axis& axis) noexcept { return static_cast<double>(axis.signals().encoder_counts); },
            "Increments of the motor encoder since power-on"},
    AxisRow{"torque", Unit::NewtonMetre, &signal<&motor::Signals::true_torque>,
            "Torque in the air gap, mean of the step"},
    AxisRow{"torque_setpoint", Unit::NewtonMetre, &signal<&motor::Signals::torque_setpoint>, "Torque setpoint"},
    AxisRow{"calculated_torque", Unit::NewtonMetre, &signal<&motor::Signals::torque>,
            "Torque that the drive computes from its currents"},
    AxisRow{"load_torque", Unit::NewtonMetre,
            [](const Axis& axis) noexcept { return axis.drive_train().load_torque(); },
            "Load torque without friction, positive against positive rotation"},
    AxisRow{"d_current", Unit::Amperes, &signal<&motor::Signals::d_current>, "Current along the flux, amplitude"},
    AxisRow{"q_current", Unit::Amperes, &signal<&motor::Signals::q_current>, "Current across the flux, amplitude"},
    AxisRow{"d_current_setpoint", Unit::Amperes, &signal<&motor::Signals::d_current_setpoint>,
            "Setpoint of the current along the flux, amplitude"},
    AxisRow{"q_current_setpoint", Unit::Amperes, &signal<&motor::Signals::q_current_setpoint>,
            "Setpoint of the current across the flux, amplitude"},
    AxisRow{"current", Unit::Amperes, &signal<&motor::Signals::current>, "Amplitude of the phase currents"},
    AxisRow{"current_u", Unit::Amperes, &phase_current<0>, "Current in phase U"},
    AxisRow{"current_v", Unit::Amperes, &phase_current<1>, "Current in phase V"},
    AxisRow{"current_w", Unit::Amperes, &phase_current<2>, "Current in phase W"},
    AxisRow{"voltage", Unit::Volts, &signal<&motor::Signals::voltage>, "Amplitude of the phase voltages"},
    AxisRow{"frequency", Unit::Hertz,
            [](const Axis& axis) noexcept { return axis.signals().frequency / (2.0 * std::numbers::pi); },
            "Frequency of the voltage"},
    AxisRow{"power", Unit::Kilowatts, &signal<&motor::Signals::power>, "Power at the terminals, mean of the step"},
    AxisRow{"flux", Unit::None, &state<&motor::PlantState::flux>, "Flux linkage of the rotor (Vs)"},
    AxisRow{"winding_temperature", Unit::Celsius, &signal<&motor::Signals::winding_temperature>,
            "Temperature of the winding"},
    AxisRow{"frame_temperature", Unit::Celsius, &signal<&motor::Signals::frame_temperature>,
            "Temperature of the frame of the motor"},
    AxisRow{"heat_sink_temperature", Unit::Celsius, &signal<&motor::Signals::heat_sink_temperature>,
            "Temperature of the heat sink of the power unit"},
    AxisRow{"chip_temperature", Unit::Celsius, &signal<&motor::Signals::chip_temperature>,
            "Temperature of the semiconductors"},
    AxisRow{"overload", Unit::Percent, &signal<&motor::Signals::overload>, "I2t of the power unit"},
    AxisRow{"motor_utilisation", Unit::Percent, &signal<&motor::Signals::motor_utilisation>,
            "I2t of the motor, of the drive's own model"},
};

constexpr std::array kUnitRows{
    UnitRow{"dc_voltage", Unit::Volts, [](const DriveUnit& unit) noexcept { return unit.dc_link().voltage(); },
            "Voltage of the DC link"},
    UnitRow{"line_voltage", Unit::VoltsRms, [](const DriveUnit& unit) noexcept { return unit.line_voltage(); },
            "Line voltage between lines"},
    UnitRow{"chopper_power", Unit::Kilowatts,
            [](const DriveUnit& unit) noexcept { return unit.dc_link().chopper_power(); },
            "Power of the braking resistor"},
};

}  // namespace

std::span<const QuantityRow<Axis>> axis_quantities() noexcept {
  return kAxisRows;
}

std::span<const QuantityRow<DriveUnit>> unit_quantities() noexcept {
  return kUnitRows;
}

}  // namespace trace
