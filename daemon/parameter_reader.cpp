#include "daemon/parameter_reader.hpp"

#include <charconv>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "drive/drive_unit.hpp"
#include "drive/parameter/bico_text.hpp"

namespace axisd {
namespace {

constexpr double kUnlimited = std::numeric_limits<double>::infinity();

/// What a BICO input of @p type can be connected to.
std::string source_expectation(drive::DataType type) {
  const bool bit = type == drive::DataType::BinectorInput;
  return fmt::format("a {} that exists, such as {}, or 0 or 1", bit ? "binector" : "connector",
                     bit ? "\"r8890.0\" or \"r0899.2 of axis 2\"" : "\"r8860[1]\" or \"r0063[0] of axis 2\"");
}

/// What should have been written instead of what @p error refused.
std::string expectation(const drive::ParameterError& error) {
  using drive::Refusal;
  const drive::ParameterRow& row = *error.row;
  if (error.reason == Refusal::NoParameter)
    return fmt::format("no {}, which this axis is delivered without", drive::parameter_text(row));
  const bool number = error.reason == Refusal::BelowMinimum || error.reason == Refusal::AboveMaximum ||
                      error.reason == Refusal::WrongType;
  if (drive::is_bico_input(row.type) && (number || error.reason == Refusal::IllegalSource))
    return source_expectation(row.type);
  if (!number) return fmt::format("no such value ({})", drive::message(error));
  const drive::Range limits = drive::limits_of(row);
  const std::string_view unit = drive::row_of(row.unit).text;
  return fmt::format("{} {} to {}{}{}", row.type == drive::DataType::F32 ? "a number" : "an integer",
                     limits.minimum, limits.maximum, unit.empty() ? "" : " ", unit);
}

/// The number in brackets behind a parameter such as p1070[1], 0 if there is none; @p text loses it.
std::optional<std::uint8_t> take_index(std::string& text) {
  const std::size_t bracket = text.find('[');
  if (bracket == std::string::npos) return std::uint8_t{0};
  std::uint8_t index = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data() + bracket + 1, end, index);
  if (error != std::errc{} || std::string_view{rest, end} != "]") return std::nullopt;
  text.resize(bracket);
  return index;
}

/// The value of parameter @p row: a number, or the text of a BICO source.
double read_value(const JsonReader& json, const drive::ParameterRow& row) {
  if (!drive::is_bico_input(row.type) || json.is_number()) return json.number(-kUnlimited, kUnlimited);
  const auto source = json.is_string() ? drive::parse_bico(json.text(), row.type) : std::nullopt;
  if (!source) json.fail(source_expectation(row.type));
  return *source;
}

/// A parameter of the drive objects of @p kind and its value; @p refused says why they would not take it.
template <class Refused>
ParameterValue read_parameter(const JsonReader& json, std::string text, drive::ObjectKind kind,
                              const Refused& refused) {
  const bool of_the_unit = kind == drive::ObjectKind::ControlUnit;
  const auto index = take_index(text);
  const drive::ParameterRow* const row = drive::find_parameter(kind, text);
  if (!index || row == nullptr)
    json.fail(of_the_unit ? "a parameter of the control unit such as p8848 as key"
                          : "a parameter of the axis such as p1120 or p1070[1] as key");
  if (*index >= row->count) json.fail(fmt::format("an index 0 to {} of {} as key", row->count - 1, text));
  const ParameterValue value{row->number, read_value(json, *row), *index};
  if (const std::optional<drive::ParameterError> error = refused(value)) json.fail(expectation(*error));
  return value;
}

/// The values under the parameters that @p json has as keys.
template <class Refused>
std::vector<ParameterValue> read_parameters(const JsonReader& json, drive::ObjectKind kind,
                                            const Refused& refused) {
  if (!json.is_object()) json.fail("an object");
  std::vector<ParameterValue> values;
  for (const std::string& text : json.keys()) values.push_back(read_parameter(json.at(text), text, kind, refused));
  return values;
}

drive::AxisConfiguration trial_of(const AxisConfiguration& axis) {
  return {.machine = axis.machine,
          .load = axis.load,
          .kind = axis.kind,
          .inverter = axis.inverter,
          .setpoint_channel = axis.setpoint_channel};
}

/// A new unit with @p axes, for trials.
drive::UnitConfiguration trial_of(const std::vector<AxisConfiguration>& axes) {
  drive::UnitConfiguration unit{.axes = {}};
  for (const AxisConfiguration& axis : axes) unit.axes.push_back(trial_of(axis));
  return unit;
}

/// Why the new axis at @p place (from 0) of @p axes would refuse @p value, if it would. What is connected to
/// another drive object needs the whole unit.
std::optional<drive::ParameterError> axis_refusal(const std::vector<AxisConfiguration>& axes, std::size_t place,
                                                  const ParameterValue& value) {
  const auto error_of = [&](drive::DriveObject& object) {
    const auto written = object.write(value.number, value.index, value.value);
    return written ? std::nullopt : std::optional{written.error()};
  };
  const drive::PlacedRow* const placed = drive::find_parameter(axes[place].kind, value.number);
  if (placed != nullptr && drive::is_bico_input(placed->row->type)) {
    drive::DriveUnit trial{trial_of(axes)};
    return error_of(trial.axes()[place]);
  }
  drive::Axis trial{trial_of(axes[place])};
  return error_of(trial);
}

}  // namespace

std::vector<ParameterValue> read_axis_parameters(const JsonReader& json,
                                                 const std::vector<AxisConfiguration>& axes, std::size_t place) {
  return read_parameters(json, axes[place].kind,
                         [&](const ParameterValue& value) { return axis_refusal(axes, place, value); });
}

std::vector<ParameterValue> read_unit_parameters(const JsonReader& json,
                                                 const std::vector<AxisConfiguration>& axes) {
  const drive::DriveUnit trial{trial_of(axes)};
  return read_parameters(json, drive::ObjectKind::ControlUnit, [&](const ParameterValue& value) {
    return trial.object(drive::kControlUnitNumber)->load_error(value.number, value.index, value.value);
  });
}

std::optional<std::string> refused_parameter(const Configuration& configuration) {
  const auto& axes = configuration.axes;
  const drive::DriveUnit unit{trial_of(axes)};
  for (const ParameterValue& value : configuration.parameters)
    if (unit.object(drive::kControlUnitNumber)->load_error(value.number, value.index, value.value))
      return fmt::format("p{:04}[{}] of the control unit", value.number, value.index);
  for (std::size_t i = 0; i < axes.size(); ++i)
    for (const ParameterValue& value : axes[i].parameters)
      if (axis_refusal(axes, i, value))
        return fmt::format("p{:04}[{}] of axis {}", value.number, value.index, axes[i].name);
  return std::nullopt;
}

}  // namespace axisd
