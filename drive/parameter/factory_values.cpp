#include "drive/parameter/factory_values.hpp"

#include <algorithm>
#include <array>

#include "drive/parameter/rounding.hpp"
#include "motor/drive_train.hpp"

namespace drive::factory {
namespace {

constexpr double kLargestHysteresis = 60000.0;  // rpm
constexpr std::size_t kMotorEncoder = 0;

/// @p speed (rad/s) in rpm.
double rpm(double speed) noexcept {
  return rounded(speed / kRpm);
}

const motor::MachineData& machine(const ObjectContext& context) noexcept {
  return context.axis.machine;
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
double encoder_fine_bits(const ObjectContext& context, std::size_t index) noexcept {
  constexpr double kOtherEncoders = 11.0;
  return index == kMotorEncoder ? static_cast<double>(machine(context).encoder.fine_bits) : kOtherEncoders;
}

double overspeed_hysteresis(const ObjectContext& context, std::size_t) noexcept {
  return rounded(std::min(0.1 * machine(context).maximum_speed / kRpm, kLargestHysteresis));
}
double speed_gain(const ObjectContext& context, std::size_t) noexcept {
  return motor::default_gains(machine(context), context.axis.load).proportional;
}
double speed_integral_time(const ObjectContext& context, std::size_t) noexcept {
  const double seconds = motor::default_gains(machine(context), context.axis.load).integral_time;
  return seconds / row_of(Unit::Milliseconds).si;
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

double object_number(const ObjectContext& context, std::size_t index) noexcept {
  return index <= context.axis_count ? static_cast<double>(index + kControlUnitNumber) : 0.0;
}
double object_type(const ObjectContext& context, std::size_t index) noexcept {
  constexpr double kUnitType = 1.0;
  if (index == 0) return kUnitType;
  return index <= context.axis_count ? drive::object_type(context.axes[index - 1]) : 0.0;
}
double object_modules(const ObjectContext& context, std::size_t index) noexcept {
  constexpr std::uint32_t kSetpointChannel = 1U << 8;
  constexpr std::uint32_t kCan = 1U << 29;
  if (index > context.axis_count) return 0.0;
  return index == 0 ? kCan : kCan | kSetpointChannel;
}

}  // namespace drive::factory
