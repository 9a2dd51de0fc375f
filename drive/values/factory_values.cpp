#include "drive/values/factory_values.hpp"

#include <algorithm>
#include <array>

#include "drive/base/function_modules.hpp"
#include "drive/machine/machine_model.hpp"
#include "drive/machine/magnetising_characteristic.hpp"
#include "drive/parameter/rounding.hpp"
#include "motor/control/field/tuning.hpp"

namespace drive::factory {
namespace {

constexpr double kLargestHysteresis = 60000.0;  // rpm
constexpr std::size_t kMotorEncoder = 0;

/// @p speed (rad/s) in rpm.
double rpm(double speed) noexcept {
  return rounded(speed / kRpm);
}

/// @p inductance (H) in mH.
double millihenries(double inductance) noexcept {
  return rounded(inductance / row_of(Unit::Millihenries).si);
}

const motor::MachineData& machine(const ObjectContext& context) noexcept {
  return context.axis.machine;
}

bool is_induction(const ObjectContext& context) noexcept {
  return machine(context).type == motor::MachineType::Induction;
}

/// @p time (s) of the holding brake in ms, that of a new unit where there is none.
double brake_time(const ObjectContext& context, double time) noexcept {
  constexpr double kWithoutBrake = 100.0;
  return context.axis.load.brake.torque > 0.0 ? rounded(time / row_of(Unit::Milliseconds).si) : kWithoutBrake;
}

/// p0400 of an encoder of the list.
struct EncoderTypeRow {
  motor::EncoderType type;
  std::uint32_t pulses;
  std::uint32_t revolutions;  ///< 0 = any
  double code;
};
constexpr std::array kEncoderTypes{
    EncoderTypeRow{motor::EncoderType::Incremental, 2048, 0, 2002.0},  // 1 Vpp with zero mark
    EncoderTypeRow{motor::EncoderType::Absolute, 2048, 4096, 2051.0},  // 1 Vpp, EnDat
};

/// What commissioning computes for the machine and all that turns with it.
motor::ControlSettings settings(const ObjectContext& context) noexcept {
  return motor::computed_settings(machine(context), context.axis.inverter,
                                  machine(context).inertia + context.axis.load.inertia);
}

}  // namespace

double rated_speed(const ObjectContext& context, std::size_t) noexcept {
  return rpm(machine(context).rated_speed);
}
double motor_maximum_speed(const ObjectContext& context, std::size_t) noexcept {
  return rpm(machine(context).maximum_speed);
}
double rated_torque(const ObjectContext& context, std::size_t) noexcept {
  return machine(context).rated_torque;
}
double rated_power(const ObjectContext& context, std::size_t) noexcept {
  return machine(context).rated_torque * machine(context).rated_speed / row_of(Unit::Kilowatts).si;
}
double motor_type(const ObjectContext& context, std::size_t) noexcept {
  return motor_type_number(machine(context).type);
}
double pole_pairs(const ObjectContext& context, std::size_t) noexcept {
  return machine(context).pole_pairs;
}
double magnetising_current(const ObjectContext& context, std::size_t) noexcept {
  return is_induction(context) ? machine(context).induction.magnetising_current : 0.0;
}
double rotor_resistance(const ObjectContext& context, std::size_t) noexcept {
  return is_induction(context) ? machine(context).induction.rotor_resistance : 0.0;
}
double stator_leakage(const ObjectContext& context, std::size_t) noexcept {
  return millihenries(is_induction(context) ? machine(context).induction.stator_leakage
                                            : machine(context).synchronous.q_inductance);
}
double rotor_leakage(const ObjectContext& context, std::size_t) noexcept {
  return is_induction(context) ? millihenries(machine(context).induction.rotor_leakage) : 0.0;
}
double main_inductance(const ObjectContext& context, std::size_t) noexcept {
  return is_induction(context) ? millihenries(machine(context).induction.magnetising_inductance) : 0.0;
}
double direct_inductance(const ObjectContext& context, std::size_t) noexcept {
  return is_induction(context) ? 0.0 : millihenries(machine(context).synchronous.d_inductance);
}
double characteristic_current_of(unsigned point, const ObjectContext& context) noexcept {
  constexpr std::array kOfASynchronousMachine{50.0, 85.0, 125.0, 210.0};  // stands there without a meaning
  if (!is_induction(context)) return kOfASynchronousMachine[point];
  return rounded(characteristic_of(machine(context)).current[point] / row_of(Unit::Percent).si);
}
double motor_inertia(const ObjectContext& context, std::size_t) noexcept {
  return machine(context).inertia;
}
double inertia_ratio(const ObjectContext& context, std::size_t) noexcept {
  return 1.0 + context.axis.load.inertia / machine(context).inertia;
}
double encoder_pulses(const ObjectContext& context, std::size_t index) noexcept {
  constexpr double kOtherEncoders = 2048.0;
  return index == kMotorEncoder ? static_cast<double>(machine(context).encoder.pulses) : kOtherEncoders;
}
double encoder_type(const ObjectContext& context, std::size_t index) noexcept {
  constexpr double kNone = 0.0, kOfTheUser = 9999.0;
  const motor::EncoderData& encoder = machine(context).encoder;
  if (index != kMotorEncoder || encoder.type == motor::EncoderType::None) return kNone;
  const auto* const row = std::ranges::find_if(kEncoderTypes, [&](const EncoderTypeRow& r) {
    return r.type == encoder.type && r.pulses == encoder.pulses &&
           (r.revolutions == 0 || r.revolutions == encoder.revolutions);
  });
  return row != kEncoderTypes.end() ? row->code : kOfTheUser;
}
double encoder_fine_bits(const ObjectContext& context, std::size_t index) noexcept {
  constexpr double kOtherEncoders = 11.0;
  return index == kMotorEncoder ? static_cast<double>(machine(context).encoder.fine_bits) : kOtherEncoders;
}

double tracking_source(const ObjectContext&, std::size_t index) noexcept {
  constexpr std::array kSources{1.0, own_source(2526, 7)};
  return kSources[index];
}
/// That of the position control is p2599; those of encoders have none.
double reference_coordinate_source(const ObjectContext&, std::size_t index) noexcept {
  return index == 0 ? own_source(2599, 0) : 0.0;
}
double gear_motor_revolutions(const ObjectContext& context, std::size_t) noexcept {
  return context.axis.mechanics.gear_motor;
}
double gear_load_revolutions(const ObjectContext& context, std::size_t) noexcept {
  return context.axis.mechanics.gear_load;
}
double units_per_load_revolution(const ObjectContext& context, std::size_t) noexcept {
  constexpr double kOfARevolution = 10000.0;  // LU
  const std::uint32_t pitch = context.axis.mechanics.pitch;
  return pitch != 0 ? static_cast<double>(pitch) : kOfARevolution;
}

double overspeed_hysteresis(const ObjectContext& context, std::size_t) noexcept {
  return rounded(std::min(0.1 * machine(context).maximum_speed / kRpm, kLargestHysteresis));
}
double speed_gain(const ObjectContext& context, std::size_t) noexcept {
  return settings(context).speed.proportional;
}
double speed_integral_time(const ObjectContext& context, std::size_t) noexcept {
  return settings(context).speed.integral_time / row_of(Unit::Milliseconds).si;
}
double encoderless_speed_gain(const ObjectContext& context, std::size_t) noexcept {
  return settings(context).sensorless_speed.proportional;
}
double encoderless_speed_integral_time(const ObjectContext& context, std::size_t) noexcept {
  return settings(context).sensorless_speed.integral_time / row_of(Unit::Milliseconds).si;
}
double brake_configuration(const ObjectContext& context, std::size_t) noexcept {
  constexpr double kBySequenceControl = 1.0;
  return context.axis.load.brake.torque > 0.0 ? kBySequenceControl : 0.0;
}
double brake_opening_time(const ObjectContext& context, std::size_t) noexcept {
  return brake_time(context, context.axis.load.brake.opening_time);
}
double brake_closing_time(const ObjectContext& context, std::size_t) noexcept {
  return brake_time(context, context.axis.load.brake.closing_time);
}
double current_limit(const ObjectContext& context, std::size_t) noexcept {
  return rounded(settings(context).current_limit);
}
double motoring_power_limit(const ObjectContext& context, std::size_t) noexcept {
  return rounded(settings(context).motoring_power_limit / row_of(Unit::Kilowatts).si);
}
double regenerative_power_limit(const ObjectContext& context, std::size_t) noexcept {
  return rounded(settings(context).regenerative_power_limit / row_of(Unit::Kilowatts).si);
}
double upper_torque_limit(const ObjectContext& context, std::size_t) noexcept {
  return machine(context).maximum_torque;
}
double lower_torque_limit(const ObjectContext& context, std::size_t) noexcept {
  return -machine(context).maximum_torque;
}

namespace {

/// p0115: current, speed and flux controller and setpoint channel run in the cycle of the control, the rest
/// slower.
double sampling_time(double control_period, std::size_t index) noexcept {
  constexpr std::size_t kFast = 4;
  constexpr double kSlow = 4000.0;  // µs
  return index < kFast ? control_period : kSlow;
}

}  // namespace

double sampling_times(const ObjectContext&, std::size_t index) noexcept {
  return sampling_time(125.0, index);
}
double vector_sampling_times(const ObjectContext&, std::size_t index) noexcept {
  return sampling_time(250.0, index);
}

namespace {

bool has_setpoint_channel(const ObjectContext& context) noexcept {
  return (function_module::of_new(context.axis) & function_module::kSetpointChannel) != 0;
}

/// 60FFh of the predefined connection set.
constexpr double kTargetVelocity = own_source(8860, 1);

/// Drive objects of the unit before its axes.
std::size_t objects_before_axes(const ObjectContext& context) noexcept {
  return first_axis_number(context.has_infeed) - std::size_t{kControlUnitNumber};
}

double infeed_type(motor::Infeed infeed) noexcept {
  constexpr double kActive = 10.0, kSmart = 20.0, kBasic = 30.0;
  if (infeed == motor::Infeed::Active) return kActive;
  return infeed == motor::Infeed::Regenerative ? kSmart : kBasic;
}

}  // namespace

double main_setpoint(const ObjectContext& context, std::size_t) noexcept {
  return has_setpoint_channel(context) ? kTargetVelocity : 0.0;
}
double speed_setpoint(const ObjectContext& context, std::size_t) noexcept {
  return has_setpoint_channel(context) ? 0.0 : kTargetVelocity;
}
double message_setpoint(const ObjectContext& context, std::size_t) noexcept {
  constexpr std::uint16_t kInFrontOfTheRamp = 1119, kBehindIt = 1438;
  return own_source(has_setpoint_channel(context) ? kInFrontOfTheRamp : kBehindIt, 0);
}

double object_number(const ObjectContext& context, std::size_t index) noexcept {
  const bool exists = index < objects_before_axes(context) + context.axis_count;
  return exists ? static_cast<double>(index + kControlUnitNumber) : 0.0;
}
double cyclic_object(const ObjectContext& context, std::size_t index) noexcept {
  if (index < context.axis_count) return static_cast<double>(first_axis_number(context.has_infeed) + index);
  return index == context.axis_count ? kControlUnitNumber : 0.0;
}
double object_type(const ObjectContext& context, std::size_t index) noexcept {
  constexpr double kUnitType = 1.0;
  const std::size_t first_axis = objects_before_axes(context);
  if (index == 0) return kUnitType;
  if (index < first_axis) return infeed_type(context.supply.infeed);
  return index < first_axis + context.axis_count ? axis_type(context.axes[index - first_axis]) : 0.0;
}
double object_modules(const ObjectContext& context, std::size_t index) noexcept {
  const std::size_t first_axis = objects_before_axes(context);
  if (index == 0) return function_module::kCan;
  return index >= first_axis && index < first_axis + context.axis_count ? context.modules[index - first_axis]
                                                                        : 0.0;
}

}  // namespace drive::factory
