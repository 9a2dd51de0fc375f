#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "drive/base/axis_configuration.hpp"
#include "drive/base/function_modules.hpp"
#include "drive/base/object_kind.hpp"
#include "drive/base/units.hpp"
#include "drive/parameter/bico.hpp"
#include "drive/parameter/home.hpp"
#include "drive/parameter/value.hpp"
#include "drive/parameter/write_condition.hpp"
#include "motor/data/supply_data.hpp"

namespace drive {

class DriveObject;

/// Limits of a parameter in its own unit, both allowed.
struct Range {
  double minimum;
  double maximum;

  friend bool operator==(const Range&, const Range&) = default;
};
/// The limits are those of the type.
inline constexpr Range kWhole{-3.4e38, 3.4e38};

/// What the factory values of a drive object depend on.
struct ObjectContext {
  ObjectKind kind = ObjectKind::Servo;
  std::uint8_t module = 0;                   ///< of an axis: 0..7 in the order of the configuration
  std::uint8_t node_id = 0;                  ///< CANopen address, 1..127; 0 = not known
  bool address_switch_off = false;           ///< of the control unit: p8620 is the address of the next power-on
  AxisConfiguration axis{};                  ///< of an axis
  motor::SupplyData supply{};                ///< the DC link that the axes share
  bool has_infeed = false;                   ///< the unit has an infeed as a drive object
  std::array<ObjectKind, kMostAxes> axes{};  ///< of the control unit: the kinds of the unit's axes
  std::array<std::uint32_t, kMostAxes> modules{};  ///< and their function modules
  std::uint8_t axis_count = 0;                     ///< of the control unit
};

/// A factory value: a number in the parameter's own unit, or how to find it for an index.
using FactoryFunction = double (*)(const ObjectContext& context, std::size_t index) noexcept;
using Factory = std::variant<double, FactoryFunction>;

/// What a BICO input can be connected to.
enum class Output : std::uint8_t {
  No,
  Connector,  ///< CO: a value for connector inputs
  Both,       ///< CO/BO: a word, whose bits are for binector inputs too
  Bits,       ///< CO/BO: a bit at each index, which is its number for binector inputs
};

/// What of a connector is 100 %.
enum class FullScale : std::uint8_t {
  OfUnit,          ///< the reference of the quantity that its unit measures
  Word,            ///< 4000h, of process data
  DoubleWord,      ///< 40000000h
  TargetVelocity,  ///< the reference speed in increments per second
  AnalogInput,     ///< 10 V
  TargetTorque,    ///< the reference torque in per mille of the rated torque
};

/// Whether a parameter is saved, and whether a factory reset changes it.
enum class Keep : std::uint8_t {
  No,      ///< neither saved nor reset: a command, a counter, a state
  Stored,  ///< both
  Always,  ///< saved, but not reset
};

/// A condition beyond state and limits; the reason against @p value, if any.
using Check = std::optional<Refusal> (*)(const DriveObject& object, std::size_t index, double value) noexcept;

/// One parameter of the kinds of drive objects that it names.
struct ParameterRow {
  std::uint16_t number;
  std::uint16_t count;  ///< indices, from 0
  ObjectKinds kinds;
  DataType type;
  Unit unit;
  Range range;
  Factory factory;
  When when;
  Home home;
  Output output;
  std::string_view name;
  std::string_view effect;  ///< what it does in the simulation, as far as its home does not say it
  Keep keep = Keep::Stored;
  Check check = nullptr;
  FullScale full_scale = FullScale::OfUnit;
  function_module::Set modules = 0;  ///< it exists with all of these only

  constexpr bool is_writable() const noexcept { return when != When::ReadOnly; }
};

/// Whether @p row is part of the saved parameters.
constexpr bool is_saved(const ParameterRow& row) noexcept {
  return row.is_writable() && row.keep != Keep::No;
}
/// Whether a factory reset changes @p row.
constexpr bool is_reset(const ParameterRow& row) noexcept {
  return row.is_writable() && row.keep == Keep::Stored;
}
/// Chooses among the saved parameters.
using RowFilter = bool (*)(const ParameterRow& row) noexcept;

/// Whether @p row is a source of binector inputs.
constexpr bool has_bits(const ParameterRow& row) noexcept {
  return row.output == Output::Both || row.output == Output::Bits;
}

/// Factory value of @p row at @p index on a drive object of @p context, in the parameter's own unit.
inline double factory_value(const ParameterRow& row, const ObjectContext& context,
                            std::size_t index = 0) noexcept {
  if (const double* const value = std::get_if<double>(&row.factory)) return *value;
  return std::get<FactoryFunction>(row.factory)(context, index);
}

/// Lowest and highest value of @p row in its own unit.
constexpr Range limits_of(const ParameterRow& row) noexcept {
  const DataTypeRow& type = row_of(row.type);
  return row.range == kWhole ? Range{type.lowest, type.highest} : row.range;
}

/// "p1120" or "r0333".
std::string parameter_text(const ParameterRow& row);

namespace rows {

using enum DataType;
using Row = ParameterRow;

/// What several rows wait for.
namespace until {
inline constexpr std::string_view kDriveObjects =
    "drive objects that are chosen over the bus; the configuration names them";
inline constexpr std::string_view kEncoder =
    "encoders that are chosen over the bus; the configuration gives the encoder";
inline constexpr std::string_view kPulses = "an inverter with pulses; it acts as their mean";
}  // namespace until

/// The parameters of a block of an axis, an array of rows; a block that has some specialises it behind its class
/// or in a header beside it that catalogue/table.cpp includes.
template <class Block>
inline constexpr std::array<Row, 0> rows_of{};

/// @p table, of parameters that exist with function module @p module only.
template <std::size_t Count>
constexpr std::array<Row, Count> with_module(function_module::Set module, std::array<Row, Count> table) noexcept {
  for (Row& row : table) row.modules |= module;
  return table;
}

/// The rows of two tables in one.
template <std::size_t First, std::size_t Second>
constexpr std::array<Row, First + Second> joined(const std::array<Row, First>& first,
                                                 const std::array<Row, Second>& second) noexcept {
  return [&]<std::size_t... I, std::size_t... J>(std::index_sequence<I...>, std::index_sequence<J...>) {
    return std::array<Row, First + Second>{first[I]..., second[J]...};
  }
  (std::make_index_sequence<First>{}, std::make_index_sequence<Second>{});
}

}  // namespace rows
}  // namespace drive
