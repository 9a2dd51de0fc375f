#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "drive/parameter/value.hpp"

namespace profidrive {

/// What is in front of values in a record: how they are represented.
enum class Format : std::uint8_t {
  Integer8 = 0x02,
  Integer16 = 0x03,
  Integer32 = 0x04,
  Unsigned8 = 0x05,
  Unsigned16 = 0x06,
  Unsigned32 = 0x07,
  FloatingPoint = 0x08,
  Zero = 0x40,
  Byte = 0x41,
  Word = 0x42,
  DoubleWord = 0x43,
  Error = 0x44,
};

/// A format, the bytes of a value, and the type that it has; those without one take any type of their size.
struct FormatRow {
  Format format;
  std::uint8_t size;
  std::optional<drive::DataType> type{};
};

inline constexpr std::array kFormats{
    FormatRow{Format::Integer8, 1, drive::DataType::I8},
    FormatRow{Format::Integer16, 2, drive::DataType::I16},
    FormatRow{Format::Integer32, 4, drive::DataType::I32},
    FormatRow{Format::Unsigned8, 1, drive::DataType::U8},
    FormatRow{Format::Unsigned16, 2, drive::DataType::U16},
    FormatRow{Format::Unsigned32, 4, drive::DataType::U32},
    FormatRow{Format::FloatingPoint, 4, drive::DataType::F32},
    FormatRow{Format::Zero, 0},
    FormatRow{Format::Byte, 1},
    FormatRow{Format::Word, 2},
    FormatRow{Format::DoubleWord, 4},
    FormatRow{Format::Error, 2},
};

/// Whether values of parameters have @p format.
constexpr bool has_values(Format format) noexcept {
  return format != Format::Zero && format != Format::Error;
}

/// The row of the format with number @p code; nullptr if there is none.
constexpr const FormatRow* find_format(std::uint8_t code) noexcept {
  const auto* const row = std::find_if(kFormats.begin(), kFormats.end(), [=](const FormatRow& r) {
    return static_cast<std::uint8_t>(r.format) == code;
  });
  return row != kFormats.end() ? row : nullptr;
}

/// The format in which values of @p type are given out; BICO sources as U32.
constexpr Format format_of(drive::DataType type) noexcept {
  const auto* const row =
      std::find_if(kFormats.begin(), kFormats.end(), [=](const FormatRow& r) { return r.type == type; });
  return row != kFormats.end() ? row->format : Format::Unsigned32;
}

}  // namespace profidrive
