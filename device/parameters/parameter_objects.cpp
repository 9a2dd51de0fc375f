#include "device/parameters/parameter_objects.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "device/objects/abort_codes.hpp"
#include "device/parameters/object_parameters.hpp"

namespace device {
namespace {

constexpr std::int64_t kLinearRamp = 0;
constexpr std::int64_t kRoundedRamp = 3;

/// With a ramp of limited jerk its slope never jumps (p1134 = 0).
constexpr std::uint16_t kRoundingType = 1134;
constexpr double kContinuous = 0.0;

constexpr std::uint16_t kUpperTorqueLimit = 1520;
constexpr std::uint16_t kLowerTorqueLimit = 1521;
constexpr double kPerMille = 1000.0;

/// Only objects of the table come here.
const ObjectParameter& row_of(const canopen::Entry& entry) noexcept {
  const std::uint16_t first = object::on_first_axis(entry.index);
  return *std::find_if(kObjectParameters.begin(), kObjectParameters.end(), [&](const ObjectParameter& row) {
    return row.index == first && row.sub_index == entry.sub_index;
  });
}

/// What parameter @p number is on a new axis.
double new_torque_limit(const drive::Axis& axis, std::uint16_t number) noexcept {
  const drive::ParameterRow& row = *drive::find_parameter(axis.kind(), number)->row;
  return drive::factory_value(row, axis.context());
}

/// p1082, which slopes refer to.
double maximum_speed(const drive::Axis& axis) noexcept {
  return axis.block<drive::SetpointChannel>().settings.maximum_speed;
}

/// Values are shown with fewer digits than they are computed with.
bool is_nearly(double value, double other) noexcept {
  constexpr double kShare = 1e-6;
  return std::abs(value - other) <= kShare * std::abs(other);
}

/// @p value as a whole number that @p entry can hold.
std::int64_t whole(double value, const canopen::Entry& entry) noexcept {
  const double values = std::ldexp(1.0, 8 * entry.size);
  const double lowest = entry.is_signed ? -values / 2.0 : 0.0;
  return std::llround(std::clamp(value, lowest, lowest + values - 1.0));
}

}  // namespace

ParameterObjects::ParameterObjects(canopen::Dictionary& dictionary, drive::Axis& axis, ParameterListener& listener)
    : axis_{axis}, listener_{listener}, scaling_{dictionary, axis} {
  for (const ObjectParameter& row : kObjectParameters) {
    const std::uint16_t index = object::on_axis(row.index, axis.axis_number());
    dictionary.own_read(index, row.sub_index, *this);
    dictionary.own_write(index, row.sub_index, *this);
  }
}

canopen::Result<std::int64_t> ParameterObjects::read(const canopen::Entry& entry, std::int64_t) {
  const ObjectParameter& row = row_of(entry);
  const auto value = axis_.read(row.parameter);
  if (!value) return canopen::refuse(abort_code(value.error().reason));
  switch (row.form) {
    case Form::Slope:
      return scaling_.get().slope_to_bus(maximum_speed(axis_), *value);
    case Form::TorqueLimit:
      if (is_nearly(*value, new_torque_limit(axis_, kUpperTorqueLimit))) return 0;
      return whole(*value / axis_.references().rated_torque * kPerMille, entry);
    case Form::ProfileType:
      return *value > 0.0 ? kRoundedRamp : kLinearRamp;
    case Form::Number:
      break;
  }
  return whole(*value, entry);
}

/// What the parameter of @p entry becomes with @p value: InvalidValue or ValueTooLow if there is nothing.
canopen::Result<double> ParameterObjects::parameter_value(const canopen::Entry& entry, std::int64_t value) const {
  const ObjectParameter& row = row_of(entry);
  if (row.form == Form::Number) return static_cast<double>(value);
  if (row.form == Form::TorqueLimit)
    return static_cast<double>(value) / kPerMille * axis_.references().rated_torque;
  if (row.form == Form::ProfileType) {
    if (value != kLinearRamp && value != kRoundedRamp) return canopen::refuse(canopen::AbortCode::InvalidValue);
    return value == kRoundedRamp ? 1.0 : 0.0;
  }
  const double longest = drive::find_parameter(axis_.kind(), row.parameter)->row->range.maximum;
  const auto time =
      scaling_.get().ramp_time_from_bus(static_cast<std::uint32_t>(value), maximum_speed(axis_), longest);
  if (!time) return canopen::refuse(canopen::AbortCode::ValueTooLow);
  return *time;
}

canopen::Result<void> ParameterObjects::write(const canopen::Entry& entry, std::int64_t value) {
  const auto wanted = parameter_value(entry, value);
  if (!wanted) return canopen::refuse(wanted.error());
  const ObjectParameter& row = row_of(entry);
  const auto written =
      row.form == Form::TorqueLimit ? write_torque_limits(*wanted) : axis_.write(row.parameter, *wanted);
  if (!written) return canopen::refuse(abort_code(written.error().reason));
  if (row.form == Form::ProfileType && *wanted > 0.0)
    static_cast<void>(axis_.write(kRoundingType, kContinuous));  // which p1115 could be written with
  listener_.on_parameter_written(axis_);
  return {};
}

tl::expected<void, drive::ParameterError> ParameterObjects::write_torque_limits(double torque) noexcept {
  const bool as_new = !(torque > 0.0);
  const double upper = as_new ? new_torque_limit(axis_, kUpperTorqueLimit) : torque;
  const double lower = as_new ? new_torque_limit(axis_, kLowerTorqueLimit) : -torque;
  const auto written = axis_.write(kUpperTorqueLimit, upper);
  return written ? axis_.write(kLowerTorqueLimit, lower) : written;
}

}  // namespace device
