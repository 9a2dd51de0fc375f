#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace drive {

/// How the value of a parameter is represented.
enum class DataType : std::uint8_t {
  I8,
  U8,
  I16,
  U16,
  I32,
  U32,
  F32,
  ConnectorInput,  ///< CI: a BICO source with an index, 32 bits
  BinectorInput,   ///< BI: a BICO source with a bit, 32 bits
};

/// A type's text, its size (bytes) and the values that it can hold.
struct DataTypeRow {
  DataType type;
  std::string_view text;
  std::uint8_t size;
  double lowest;
  double highest;
};

/// One row a type, in the order of the enumeration.
inline constexpr std::array kDataTypes{
    DataTypeRow{DataType::I8, "I8", 1, -128.0, 127.0},
    DataTypeRow{DataType::U8, "U8", 1, 0.0, 255.0},
    DataTypeRow{DataType::I16, "I16", 2, -32768.0, 32767.0},
    DataTypeRow{DataType::U16, "U16", 2, 0.0, 65535.0},
    DataTypeRow{DataType::I32, "I32", 4, -2147483648.0, 2147483647.0},
    DataTypeRow{DataType::U32, "U32", 4, 0.0, 4294967295.0},
    DataTypeRow{DataType::F32, "F32", 4, -3.4e38, 3.4e38},
    DataTypeRow{DataType::ConnectorInput, "CI", 4, 0.0, 4294967295.0},
    DataTypeRow{DataType::BinectorInput, "BI", 4, 0.0, 4294967295.0},
};
static_assert([] {
  for (std::size_t i = 0; i < kDataTypes.size(); ++i)
    if (kDataTypes[i].type != static_cast<DataType>(i)) return false;
  return true;
}());

/// The row of @p type.
constexpr const DataTypeRow& row_of(DataType type) noexcept {
  return kDataTypes[static_cast<std::size_t>(type)];
}

/// Whether a parameter of @p type holds a BICO source.
constexpr bool is_bico_input(DataType type) noexcept {
  return type == DataType::ConnectorInput || type == DataType::BinectorInput;
}

/// A value as it is transferred: an integer, sign-extended to 32 bits, or the bits of a REAL32.
struct ParameterValue {
  DataType type = DataType::U32;
  std::uint32_t bits = 0;

  friend bool operator==(const ParameterValue&, const ParameterValue&) = default;
};

/// @p number as @p type represents it; it has to be within the limits of the type. A double holds the values of
/// every type exactly.
constexpr ParameterValue encode(DataType type, double number) noexcept {
  if (type == DataType::F32) return {type, std::bit_cast<std::uint32_t>(static_cast<float>(number))};
  return {type, static_cast<std::uint32_t>(static_cast<std::int64_t>(number))};
}

/// The number that @p value stands for; of a shorter type only its own bits count.
constexpr double decode(const ParameterValue& value) noexcept {
  if (value.type == DataType::F32) return static_cast<double>(std::bit_cast<float>(value.bits));
  const DataTypeRow& row = row_of(value.type);
  const unsigned unused = 32U - 8U * row.size;
  const std::uint32_t shifted = value.bits << unused;
  if (row.lowest < 0.0) return static_cast<double>(static_cast<std::int32_t>(shifted) >> unused);
  return static_cast<double>(shifted >> unused);
}

}  // namespace drive
