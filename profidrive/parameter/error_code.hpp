#pragma once

#include <cstdint>
#include <optional>

#include "drive/parameter/error.hpp"

namespace profidrive {

/// The reason that masters are told of @p error: a @p value beyond the limits of the parameter's own row is
/// OutOfRange, so BelowMinimum and AboveMaximum are left for limits that other parameters set.
drive::RefusalReason told_reason(const drive::ParameterError& error,
                                 std::optional<double> value = std::nullopt) noexcept;

/// The same as a number of the list of errors.
inline std::uint8_t error_code(const drive::ParameterError& error,
                               std::optional<double> value = std::nullopt) noexcept {
  return static_cast<std::uint8_t>(told_reason(error, value));
}

}  // namespace profidrive
