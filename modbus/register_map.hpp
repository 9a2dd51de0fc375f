#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace modbus {

/// What a register holds.
enum class Content : std::uint8_t {
  ReceivedWord,   ///< process data that the axis receives (r2050), one word a register
  SentWord,       ///< process data that the axis sends (r2053), likewise
  AxisParameter,  ///< a parameter of the axis, one index a register
  UnitParameter,  ///< a parameter of the control unit
  RefusalCode,    ///< why the last access was refused, as a record has it
  Technology,     ///< of the technology controller, which the unit does not have: as if it were reserved
  Record,         ///< the mailbox of records
};

enum class Access : std::uint8_t { Read, ReadWrite };

/// How a number becomes that of a register.
struct Scale {
  std::uint16_t multiplier = 1;
  std::uint16_t divisor = 1;  ///< with one other than 1 the fraction is cut off, not rounded
  bool is_signed = false;     ///< two's complement
};

/// Registers in a row that hold the same kind of thing.
struct RegisterRow {
  std::uint16_t first, last;
  Content content;
  Access access;
  std::uint16_t parameter = 0;  ///< of the first register the index 0, of the next ones those that follow
  Scale scale{};
  std::string_view what{};  ///< in a few words

  constexpr bool is_writable() const noexcept { return access == Access::ReadWrite; }
};

/// All rows in ascending order; a register of none is reserved.
std::span<const RegisterRow> register_map() noexcept;

/// The row of register @p number, or nullptr.
const RegisterRow* find_register(std::uint16_t number) noexcept;

/// What a register of @p scale shows of @p value: rounded half away from zero or cut off, at the ends of 16 bits
/// saturated.
std::uint16_t shown(const Scale& scale, double value) noexcept;
/// The number that @p shown stands for in a register of @p scale.
double value_of(const Scale& scale, std::uint16_t shown) noexcept;

}  // namespace modbus
