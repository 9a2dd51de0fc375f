#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include <tl/expected.hpp>

#include "drive/parameters.hpp"
#include "drive/units.hpp"

namespace drive {

/// When a parameter may be written.
enum class Access : std::uint8_t {
  ReadOnly,
  PulsesOff,  ///< "T": ready to run, pulses off
  Always,     ///< "U, T": also while running
};

/// Where the value of a parameter lies.
using ParameterMember = std::variant<double AxisParameters::*, std::int32_t AxisParameters::*>;

/// One parameter; limits and factory value are in the parameter's own unit.
struct ParameterRow {
  std::uint16_t number;
  std::string_view text;  ///< "p1120"
  std::string_view name;
  Unit unit;
  double minimum;
  double maximum;
  double factory;  ///< before the motor data are known
  Access access;
  ParameterMember member;
};

/// Why a parameter was not read or written.
struct ParameterError {
  enum class Reason : std::uint8_t { Unknown, ReadOnly, PulsesEnabled, NotAnInteger, BelowMinimum, AboveMaximum };
  Reason reason;
  std::uint16_t number;
  const ParameterRow* row;  ///< with name, unit and limits; nullptr if there is no such parameter
};

/// One line of plain text for @p error, such as "p1120: above the maximum of 999999 s".
std::string message(const ParameterError& error);

/// All parameters of an axis, ascending by number.
std::span<const ParameterRow> parameter_rows() noexcept;

/// The row of parameter @p number, or nullptr.
const ParameterRow* find_parameter(std::uint16_t number) noexcept;

/// The row of the parameter written as "p1120" or "r0333", or nullptr.
const ParameterRow* find_parameter(std::string_view text) noexcept;

/// Value of parameter @p number in its own unit.
[[nodiscard]] tl::expected<double, ParameterError> read(const AxisParameters& parameters,
                                                        std::uint16_t number) noexcept;

/// Sets parameter @p number to @p value in its own unit; a value outside the limits is refused.
[[nodiscard]] tl::expected<void, ParameterError> write(AxisParameters& parameters, std::uint16_t number,
                                                       double value) noexcept;

}  // namespace drive
