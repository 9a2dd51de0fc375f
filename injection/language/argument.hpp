#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace injection {

/// What a kind of fault can be told beside when it happens.
enum class Argument : std::uint8_t {
  Code,
  Object,
  SubIndex,
  Server,
  Step,
  Pdo,
  DelayMs,
  PeriodMs,
  Length,
  First,
  Second,
  NmtState,
  DriveState,
  Bit,
  Value,
  Axis,
  NodeId,
  Id,
  Mask,
  Byte,
  Bits,
  PeriodUs,
  ErrorClass,
  BitRate,
  Percent,
  Members,
  Count
};
inline constexpr std::size_t kArguments = static_cast<std::size_t>(Argument::Count);

/// How the value of an argument is written.
enum class Form : std::uint8_t { Decimal, Hexadecimal, Word, Text };

/// An argument: its key, what it may be and what it says. All values are whole numbers; of a word the place among
/// @p words, of a text (of so many characters) the place in Fault::texts.
struct ArgumentRow {
  Argument argument;
  std::string_view key;
  Form form;
  std::uint32_t low;
  std::uint32_t high;
  std::string_view summary;
  std::span<const std::string_view> words{};
};

/// The row of @p argument.
const ArgumentRow& row_of(Argument argument) noexcept;
/// All rows, in the order of Argument.
std::span<const ArgumentRow> argument_rows() noexcept;

/// How a kind of fault uses an argument.
struct ArgumentUse {
  Argument argument;
  std::string_view absent;  ///< what holds without it ("all"); empty: it is required
};

}  // namespace injection
