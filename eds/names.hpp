#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "libcanopen/od/entry_description.hpp"

namespace eds {

/// Object codes by their number in an EDS (CiA 306, ObjectType).
enum class ObjectCode : std::uint8_t { Variable = 7, Array = 8, Record = 9 };

/// How often an object exists in a unit.
enum class Scope : std::uint8_t {
  Unit,  ///< once
  Axis,  ///< once an axis; the catalogue gives axis 1
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

/// Object codes, spelled as CiA 301 spells them.
inline constexpr std::array kObjectCodes{
    Name<ObjectCode>{ObjectCode::Variable, "VAR", "Variable"},
    Name<ObjectCode>{ObjectCode::Array, "ARRAY", "Array"},
    Name<ObjectCode>{ObjectCode::Record, "RECORD", "Record"},
};

/// Scopes of an object.
inline constexpr std::array kScopes{
    Name<Scope>{Scope::Unit, "unit", "Unit"},
    Name<Scope>{Scope::Axis, "axis", "Axis"},
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
