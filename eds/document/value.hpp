#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace eds {

/// An integer of any type of CiA 301: sign and magnitude.
struct Integer {
  std::uint64_t magnitude = 0;
  bool negative = false;  ///< never set with magnitude 0

  friend std::strong_ordering operator<=>(const Integer& one, const Integer& other) noexcept;
  friend bool operator==(const Integer&, const Integer&) = default;
};

/// An integer as a file writes it.
struct IntegerText {
  Integer value{};             ///< without the node-ID
  bool node_relative = false;  ///< the node-ID is added
  bool sum = false;            ///< "$NODEID+..." or "...+$NODEID"; not "$NODEID" alone
  bool hexadecimal = false;    ///< written with 0x
};

/// Reads decimal, 0x hexadecimal and 0 octal numbers of up to 64 bits and a sign, alone or added to $NODEID in
/// either order (CiA 306), in any letter case and with blanks around each part; nothing for anything else.
[[nodiscard]] std::optional<IntegerText> parse_integer(std::string_view text) noexcept;

/// How the values of a data type are written and compared.
enum class ValueKind : std::uint8_t {
  Signed,    ///< two's complement of `bits`
  Unsigned,  ///< also BOOLEAN and the times
  Real,
  Text,   ///< VISIBLE_STRING, UNICODE_STRING
  Bytes,  ///< OCTET_STRING, DOMAIN: pairs of hexadecimal digits
};

/// A data type that an EDS may name (CiA 301, table 44).
struct DataTypeRow {
  std::uint16_t number = 0;
  std::string_view name{};
  ValueKind kind = ValueKind::Unsigned;
  std::uint8_t bits = 0;  ///< of a number; 0 for texts, bytes and records
};

/// The data type @p number; null for records (0020h and above), reserved numbers and those of the manufacturer.
[[nodiscard]] const DataTypeRow* find_data_type(std::uint64_t number) noexcept;

/// Node-IDs that a file is for, the first and the last.
struct NodeRange {
  unsigned first = 1;
  unsigned last = 127;
};
/// Those of an EDS; a DCF is for one.
inline constexpr NodeRange kAnyNode{};

/// A value of an entry.
struct Value {
  ValueKind kind = ValueKind::Unsigned;
  Integer integer{};           ///< of Signed and Unsigned, without the node-ID
  bool node_relative = false;  ///< the node-ID (1..127) is added
  double real = 0;             ///< of Real
  std::string text{};          ///< of Text and Bytes, as written

  /// Integer value on node @p node_id; nothing where it needs more than 64 bits.
  [[nodiscard]] std::optional<Integer> at(unsigned node_id) const noexcept;
};

/// Why a text is no value of a type.
struct ValueError {
  bool out_of_range = false;  ///< a number, but none of the type
  std::string expected{};
};

/// Reads @p text as a value of @p type. The hexadecimal form of a signed type may be its two's complement, that of
/// REAL32 and REAL64 its bit pattern. What the node-ID is added to must fit on every one of @p nodes.
[[nodiscard]] tl::expected<Value, ValueError> parse_value(std::string_view text, const DataTypeRow& type,
                                                          NodeRange nodes = kAnyNode);

/// True when @p one is at most @p other, two values of one type, on every one of @p nodes; also where they have no
/// order, as texts.
[[nodiscard]] bool ordered(const Value& one, const Value& other, NodeRange nodes = kAnyNode) noexcept;

/// @p written, the text of @p value, with the number behind it where the form hides its sign: "0xFFFF (-1)".
[[nodiscard]] std::string with_sign(std::string_view written, const Value& value);

/// The decimal form of @p integer.
[[nodiscard]] std::string to_text(const Integer& integer);

}  // namespace eds
