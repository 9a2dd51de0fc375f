#include "daemon/configuration/parameter_reader.hpp"

#include <array>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "drive/drive_unit.hpp"
#include "drive/parameter/bico_text.hpp"
#include "text/number.hpp"

namespace axisd {
namespace {

constexpr double kUnlimited = std::numeric_limits<double>::infinity();
/// A parameter of each drive::ObjectKind, for messages.
constexpr std::array<std::string_view, drive::kObjectKindCount> kExamples{
    "of the control unit such as p8848", "of the axis such as p1120 or p1070[1]",
    "of the axis such as p1120 or p1070[1]", "of the infeed such as p0840"};

/// What a BICO input of @p type can be connected to.
std::string source_expectation(drive::DataType type) {
  const bool bit = type == drive::DataType::BinectorInput;
  return fmt::format("a {} that exists, such as {}, or 0 or 1", bit ? "binector" : "connector",
                     bit ? R"("r8890.0" or "r0899.2 of axis 2")" : R"("r8860[1]" or "r0063[0] of axis 2")");
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
  std::string_view rest = std::string_view{text}.substr(bracket + 1);
  const auto index = text::take_integer<std::uint8_t>(rest);
  if (!index || rest != "]") return std::nullopt;
  text.resize(bracket);
  return index;
}

/// The value of parameter @p row: a number, or the text of a BICO source. @p first_axis: a drive object number.
double read_value(const JsonReader& json, const drive::ParameterRow& row, std::uint8_t first_axis) {
  if (!drive::is_bico_input(row.type) || json.is_number()) return json.number(-kUnlimited, kUnlimited);
  const auto source = json.is_string() ? drive::parse_bico(json.text(), row.type, first_axis) : std::nullopt;
  if (!source) json.fail(source_expectation(row.type));
  return *source;
}

/// A new unit of @p configuration, for trials.
drive::UnitConfiguration trial_of(const Configuration& configuration) {
  drive::UnitConfiguration unit{.axes = {}, .infeed = configuration.infeed.has_value()};
  for (const AxisConfiguration& axis : configuration.axes)
    unit.axes.push_back({.machine = axis.machine,
                         .load = axis.load,
                         .kind = axis.kind,
                         .inverter = axis.inverter,
                         .setpoint_channel = axis.setpoint_channel,
                         .mechanics = axis.mechanics,
                         .positioner = axis.positioner});
  return unit;
}

/// Why the drive object @p number of a new unit would refuse @p value, if it would: @p unit is one, and takes it.
/// Of the control unit only what it saves can be configured.
std::optional<drive::ParameterError> refusal(drive::DriveUnit& unit, std::uint8_t number,
                                             const ParameterValue& value) {
  drive::DriveObject& object = *unit.object(number);
  if (number == drive::kControlUnitNumber) return object.load_error(value.number, value.index, value.value);
  const drive::ParameterRow* const row = drive::find_parameter(object.kind(), value.number)->row;
  // A command is carried out once: it is no state that could be laid over that of a new unit.
  if (std::holds_alternative<drive::HostCommand>(row->home))
    return drive::ParameterError{drive::Refusal::ReadOnly, value.number, row};
  const auto written = object.write(value.number, value.index, value.value);
  return written ? std::nullopt : std::optional{written.error()};
}

/// Reads what drive objects of a new unit take.
class ParameterReader {
 public:
  explicit ParameterReader(const Configuration& configuration) : trial_{trial_of(configuration)} {}

  /// The values under the parameters that @p json has as keys, each as drive object @p number takes it by itself.
  std::vector<ParameterValue> read(const JsonReader& json, std::uint8_t number) const {
    if (!json.is_object()) json.fail("an object");
    std::vector<ParameterValue> values;
    for (const std::string& text : json.keys()) values.push_back(read_parameter(json.at(text), text, number));
    return values;
  }

 private:
  ParameterValue read_parameter(const JsonReader& json, std::string text, std::uint8_t number) const {
    drive::DriveUnit unit{trial_};
    const drive::ObjectKind kind = unit.object(number)->kind();
    const auto index = take_index(text);
    const drive::ParameterRow* const row = drive::find_parameter(kind, text);
    if (!index || row == nullptr)
      json.fail(fmt::format("a parameter {} as key", kExamples[static_cast<std::size_t>(kind)]));
    if (*index >= row->count) json.fail(fmt::format("an index 0 to {} of {} as key", row->count - 1, text));
    const ParameterValue value{row->number, read_value(json, *row, unit.first_axis()), *index};
    if (const auto refused = refusal(unit, number, value)) json.fail(expectation(*refused));
    return value;
  }

  drive::UnitConfiguration trial_;
};

}  // namespace

void read_parameters(const JsonReader& json, Configuration& configuration) {
  const ParameterReader reader{configuration};
  if (json.has("parameters"))
    configuration.parameters = reader.read(json.at("parameters"), drive::kControlUnitNumber);
  if (configuration.infeed && json.at("infeed").is_object() && json.at("infeed").has("parameters"))
    configuration.infeed->parameters = reader.read(json.at("infeed").at("parameters"), drive::kInfeedNumber);
  if (!json.has("axes")) return;
  std::uint8_t number = drive::first_axis_number(configuration.infeed.has_value());
  for (std::size_t i = 0; i < configuration.axes.size(); ++i, ++number)
    if (const JsonReader axis = json.at("axes").at(i); axis.has("parameters"))
      configuration.axes[i].parameters = reader.read(axis.at("parameters"), number);
}

std::optional<std::string> refused_parameter(const Configuration& configuration) {
  const auto first_of = [&configuration](const std::vector<ParameterValue>& values, std::uint8_t number,
                                         const std::string& owner) -> std::optional<std::string> {
    for (const ParameterValue& value : values) {
      drive::DriveUnit unit{trial_of(configuration)};
      if (refusal(unit, number, value)) return fmt::format("p{:04}[{}] of {}", value.number, value.index, owner);
    }
    return std::nullopt;
  };
  if (auto refused = first_of(configuration.parameters, drive::kControlUnitNumber, "the control unit"))
    return refused;
  if (configuration.infeed)
    if (auto refused = first_of(configuration.infeed->parameters, drive::kInfeedNumber, "the infeed"))
      return refused;
  std::uint8_t number = drive::first_axis_number(configuration.infeed.has_value());
  for (const AxisConfiguration& axis : configuration.axes)
    if (auto refused = first_of(axis.parameters, number++, "axis " + axis.name)) return refused;
  return std::nullopt;
}

}  // namespace axisd
