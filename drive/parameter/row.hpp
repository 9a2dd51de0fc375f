#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "drive/axis_configuration.hpp"
#include "drive/object_kind.hpp"
#include "drive/parameter/bico.hpp"
#include "drive/parameter/value.hpp"
#include "drive/parameter/write_condition.hpp"
#include "drive/parameters.hpp"
#include "drive/units.hpp"
#include "motor/supply_data.hpp"

namespace drive {

class Axis;
class ControlUnit;
class DriveObject;
class FaultMemory;
class Infeed;

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

/// The value lies in a slot of the drive object and nothing in the simulation acts on it.
struct Stored {
  std::string_view until = {};  ///< what would act on it; empty if a function module that is missing says so
};
/// The value lies in a slot of the drive object, and what the row's effect names is computed from it.
struct Slot {};
/// The value lies in a slot of the drive object; the layer that owns the bus acts on it, agrees to every change
/// and brings in its own ones.
struct Agreed {};
/// A command to the layer that owns the bus; what it reads as is what that layer brings in, otherwise the factory
/// value.
struct Command {};
/// The quantity is not in the model: it reads as `value`.
struct Fixed {
  double value;
  std::string_view until = {};  ///< what would change it; empty if a function module that is missing says so
};
/// The value is a member of AxisParameters, in SI units there.
struct Member {
  std::variant<double AxisParameters::*, std::int32_t AxisParameters::*> member;
};
/// The value is found and set by functions of the kind of object that it belongs to, in the parameter's own unit;
/// a display has no function that sets it.
template <class Owner>
struct Computed {
  double (*get)(const Owner& owner, std::size_t index) noexcept;
  void (*set)(Owner& owner, std::size_t index, double value) noexcept = nullptr;
};

/// Where the value of a parameter lives.
using Home = std::variant<Stored, Slot, Agreed, Command, Fixed, Member, Computed<Axis>, Computed<ControlUnit>,
                          Computed<Infeed>, Computed<DriveObject>, Computed<FaultMemory>>;

/// What a BICO input can be connected to.
enum class Output : std::uint8_t {
  No,
  Connector,  ///< CO: a value for connector inputs
  Both,       ///< CO/BO: a word, whose bits are for binector inputs too
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
  std::uint8_t count;  ///< indices, from 0
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

/// Whether the bits that @p row has for binector inputs are its indices (r8843).
constexpr bool has_a_bit_per_index(const ParameterRow& row) noexcept {
  constexpr std::uint16_t kInterfaceState = 8843;
  return row.number == kInterfaceState;
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
using P = AxisParameters;

/// What several rows wait for.
namespace until {
inline constexpr std::string_view kDriveObjects =
    "drive objects that are chosen over the bus; the configuration names them";
inline constexpr std::string_view kEncoder =
    "encoders that are chosen over the bus; the configuration gives the encoder";
inline constexpr std::string_view kPulses = "an inverter with pulses; it acts as their mean";
}  // namespace until

// What a row gives as its home, where the name of the type would be long.
constexpr Computed<Axis> axis(double (*get)(const Axis&, std::size_t) noexcept,
                              void (*set)(Axis&, std::size_t, double) noexcept = nullptr) noexcept {
  return {get, set};
}
constexpr Computed<ControlUnit> unit(double (*get)(const ControlUnit&, std::size_t) noexcept,
                                     void (*set)(ControlUnit&, std::size_t, double) noexcept = nullptr) noexcept {
  return {get, set};
}
constexpr Computed<Infeed> infeed(double (*get)(const Infeed&, std::size_t) noexcept) noexcept {
  return {get};
}
constexpr Computed<DriveObject> object(double (*get)(const DriveObject&, std::size_t) noexcept,
                                       void (*set)(DriveObject&, std::size_t,
                                                   double) noexcept = nullptr) noexcept {
  return {get, set};
}
constexpr Computed<FaultMemory> messages(double (*get)(const FaultMemory&, std::size_t) noexcept,
                                         void (*set)(FaultMemory&, std::size_t,
                                                     double) noexcept = nullptr) noexcept {
  return {get, set};
}

}  // namespace rows
}  // namespace drive
