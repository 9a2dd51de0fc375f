#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "libcanopen/od/data_type.hpp"

namespace eds {

/// A number as the catalogue writes it, and an EDS: decimal, 0x hexadecimal, 0 octal, or one of these after
/// "$NODEID+" (CiA 306, 4.6.3).
struct Number {
  std::int64_t value = 0;      ///< without the node-ID
  bool node_relative = false;  ///< the node-ID (1..127) is added
  double real = 0;             ///< value of a REAL32, whose `value` is 0
  std::string text;            ///< as written

  /// The number on node @p node_id.
  [[nodiscard]] std::int64_t at(std::int64_t node_id) const noexcept {
    return node_relative ? value + node_id : value;
  }
};

/// Reads @p text whole; nothing where it is not one number of at most 32 bits and a sign.
[[nodiscard]] std::optional<Number> parse_number(std::string_view text);

/// Reads @p text whole as a decimal number of type REAL32; nothing where it is none.
[[nodiscard]] std::optional<Number> parse_real(std::string_view text);

/// Reads @p text whole as @p digits hexadecimal digits, without any prefix; nothing where it is something else.
[[nodiscard]] std::optional<std::uint32_t> parse_hexadecimal(std::string_view text, std::size_t digits);

/// Smallest and largest value of an integer type.
struct Range {
  std::int64_t low = 0;
  std::int64_t high = 0;
};

/// Range of @p type; nothing for strings, DOMAIN, REAL and what is longer than 32 bits.
[[nodiscard]] std::optional<Range> range_of(canopen::DataType type) noexcept;

/// True when @p number lies within @p range whatever the node-ID is.
[[nodiscard]] bool within(const Number& number, const Range& range) noexcept;

/// True when @p smaller is at most @p larger whatever the node-ID is.
[[nodiscard]] bool ordered(const Number& smaller, const Number& larger) noexcept;

}  // namespace eds
