#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "libcanopen/od/entry_description.hpp"

namespace eds {

/// Object codes by their number in an EDS (CiA 306, ObjectType; CiA 301, table 42).
enum class ObjectCode : std::uint8_t {
  Null = 0,
  Domain = 2,
  DefType = 5,
  DefStruct = 6,
  Variable = 7,
  Array = 8,
  Record = 9,
};

/// Where an object exists: in the dictionary of the unit, or among the parameters of a drive object.
enum class Scope : std::uint8_t {
  Unit,                  ///< once in a unit
  Axis,                  ///< once an axis; the catalogue gives axis 1
  Parameter,             ///< every drive object
  ControlUnitParameter,  ///< the control unit
  AxisParameter,         ///< axes of both types
  ServoParameter,        ///< servo axes
  VectorParameter,       ///< vector axes
};

/// What kind of drive object an axis is.
enum class DriveType : std::uint8_t { Servo, Vector };

/// What an EDS file describes.
enum class FileContent : std::uint8_t {
  Axes,         ///< the unit with a fixed number of servo axes
  Modules,      ///< the unit with its axes as modules
  ControlUnit,  ///< the control unit and its parameters
  Servo,        ///< a servo axis as drive object, with its parameters
  Vector,       ///< a vector axis likewise
};

/// A value and the word that stands for it in the catalogue and in C++.
template <class T>
struct Name {
  T value;
  std::string_view text;        ///< in the catalogue
  std::string_view enumerator;  ///< in C++
};

/// Data types that the catalogue may use.
inline constexpr std::array kDataTypes{
    Name<canopen::DataType>{canopen::DataType::Boolean, "BOOLEAN", "Boolean"},
    Name<canopen::DataType>{canopen::DataType::Integer8, "INTEGER8", "Integer8"},
    Name<canopen::DataType>{canopen::DataType::Integer16, "INTEGER16", "Integer16"},
    Name<canopen::DataType>{canopen::DataType::Integer32, "INTEGER32", "Integer32"},
    Name<canopen::DataType>{canopen::DataType::Unsigned8, "UNSIGNED8", "Unsigned8"},
    Name<canopen::DataType>{canopen::DataType::Unsigned16, "UNSIGNED16", "Unsigned16"},
    Name<canopen::DataType>{canopen::DataType::Unsigned32, "UNSIGNED32", "Unsigned32"},
    Name<canopen::DataType>{canopen::DataType::Real32, "REAL32", "Real32"},
    Name<canopen::DataType>{canopen::DataType::VisibleString, "VISIBLE_STRING", "VisibleString"},
};

/// Access attributes, spelled as CiA 306 spells AccessType.
inline constexpr std::array kAccesses{
    Name<canopen::Access>{canopen::Access::ReadOnly, "ro", "ReadOnly"},
    Name<canopen::Access>{canopen::Access::WriteOnly, "wo", "WriteOnly"},
    Name<canopen::Access>{canopen::Access::ReadWrite, "rw", "ReadWrite"},
    Name<canopen::Access>{canopen::Access::ReadWriteRead, "rwr", "ReadWriteRead"},
    Name<canopen::Access>{canopen::Access::ReadWriteWrite, "rww", "ReadWriteWrite"},
    Name<canopen::Access>{canopen::Access::Constant, "const", "Constant"},
};

/// Object codes that the catalogue may use, spelled as CiA 301 spells them.
inline constexpr std::array kObjectCodes{
    Name<ObjectCode>{ObjectCode::Variable, "VAR", "Variable"},
    Name<ObjectCode>{ObjectCode::Array, "ARRAY", "Array"},
    Name<ObjectCode>{ObjectCode::Record, "RECORD", "Record"},
};

/// Scopes of an object in the dictionary of the unit.
inline constexpr std::array kObjectScopes{
    Name<Scope>{Scope::Unit, "unit", "Unit"},
    Name<Scope>{Scope::Axis, "axis", "Axis"},
};

/// Scopes of a parameter object.
inline constexpr std::array kParameterScopes{
    Name<Scope>{Scope::Parameter, "parameter", "Parameter"},
    Name<Scope>{Scope::ControlUnitParameter, "cu-parameter", "ControlUnitParameter"},
    Name<Scope>{Scope::AxisParameter, "axis-parameter", "AxisParameter"},
    Name<Scope>{Scope::ServoParameter, "servo-parameter", "ServoParameter"},
    Name<Scope>{Scope::VectorParameter, "vector-parameter", "VectorParameter"},
};

/// Contents of an EDS file.
inline constexpr std::array kFileContents{
    Name<FileContent>{FileContent::Axes, "axes", "Axes"},
    Name<FileContent>{FileContent::Modules, "modules", "Modules"},
    Name<FileContent>{FileContent::ControlUnit, "control-unit", "ControlUnit"},
    Name<FileContent>{FileContent::Servo, "servo", "Servo"},
    Name<FileContent>{FileContent::Vector, "vector", "Vector"},
};

/// Who judges the limits of an entry.
inline constexpr std::array kLimitChecks{
    Name<canopen::LimitCheck>{canopen::LimitCheck::Table, "table", "Table"},
    Name<canopen::LimitCheck>{canopen::LimitCheck::Owner, "owner", "Owner"},
};

/// The value that @p text names in @p table.
template <class T, std::size_t N>
[[nodiscard]] constexpr std::optional<T> value_of(const std::array<Name<T>, N>& table,
                                                  std::string_view text) noexcept {
  const auto found = std::ranges::find(table, text, &Name<T>::text);
  if (found == table.end()) return std::nullopt;
  return found->value;
}

/// The row of @p value in @p table, which must hold it.
template <class T, std::size_t N>
[[nodiscard]] constexpr const Name<T>& name_of(const std::array<Name<T>, N>& table, T value) noexcept {
  return *std::ranges::find(table, value, &Name<T>::value);
}

}  // namespace eds
