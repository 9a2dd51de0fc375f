#include "device/parameter_objects.hpp"

#include <algorithm>
#include <array>

#include "device/abort_codes.hpp"
#include "device/object_index.hpp"

namespace device {
namespace {

/// How an object shows its parameter.
enum class Form : std::uint8_t {
  Number,  ///< as it is
  Slope,   ///< a ramp time as the slope from p1082 (increments/s²)
};

struct Row {
  std::uint16_t index;
  std::uint16_t parameter;
  Form form;
};
constexpr std::array kRows{
    Row{object::kAbortConnectionOption, 8641, Form::Number}, Row{object::kHaltOption, 8791, Form::Number},
    Row{object::kProfileAcceleration, 1120, Form::Slope},    Row{object::kProfileDeceleration, 1121, Form::Slope},
    Row{object::kQuickStopDeceleration, 1135, Form::Slope},
};

/// Only objects of the table come here.
const Row& row_of(std::uint16_t index) noexcept {
  const std::uint16_t first = object::on_first_axis(index);
  return *std::find_if(kRows.begin(), kRows.end(), [=](const Row& row) { return row.index == first; });
}

}  // namespace

ParameterObjects::ParameterObjects(canopen::Dictionary& dictionary, drive::Axis& axis,
                                   const drive::BusScaling& scaling, ParameterListener& listener)
    : axis_{axis}, listener_{listener}, scaling_{scaling} {
  for (const Row& row : kRows) {
    const std::uint16_t index = object::on_axis(row.index, axis.axis_number());
    dictionary.own_read(index, 0, *this);
    dictionary.own_write(index, 0, *this);
  }
}

canopen::Result<std::int64_t> ParameterObjects::read(const canopen::Entry& entry, std::int64_t) {
  const Row& row = row_of(entry.index);
  const auto value = axis_.read(row.parameter);
  if (!value) return canopen::refuse(abort_code(value.error().reason));
  if (row.form == Form::Number) return static_cast<std::int64_t>(*value);
  return scaling_.slope_to_bus(axis_.parameters().maximum_speed, *value);
}

canopen::Result<void> ParameterObjects::write(const canopen::Entry& entry, std::int64_t value) {
  const Row& row = row_of(entry.index);
  auto parameter_value = static_cast<double>(value);
  if (row.form == Form::Slope) {
    const double longest = drive::find_parameter(axis_.kind(), row.parameter)->row->range.maximum;
    const auto time =
        scaling_.ramp_time_from_bus(static_cast<std::uint32_t>(value), axis_.parameters().maximum_speed, longest);
    if (!time) return canopen::refuse(canopen::AbortCode::ValueTooLow);
    parameter_value = *time;
  }
  const auto written = axis_.write(row.parameter, parameter_value);
  if (!written) return canopen::refuse(abort_code(written.error().reason));
  listener_.on_parameter_written(axis_);
  return {};
}

}  // namespace device
