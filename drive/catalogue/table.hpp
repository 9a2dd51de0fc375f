#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "drive/parameter/row.hpp"

namespace drive {

/// A parameter of a kind of drive object, and the slot that its index 0 has there; further indices follow.
struct PlacedRow {
  const ParameterRow* row;
  std::uint16_t slot;  ///< below slot_count(), or kNoSlot for a value that lives elsewhere
};
inline constexpr std::uint16_t kNoSlot = 0xFFFF;

/// All rows, ascending by number; one with a row for each kind of axis has two.
std::span<const ParameterRow* const> parameter_rows() noexcept;

/// The parameters of @p kind, ascending by number.
std::span<const PlacedRow> parameters_of(ObjectKind kind) noexcept;

/// Slots that a drive object of @p kind needs.
std::size_t slot_count(ObjectKind kind) noexcept;

/// Parameter @p number of @p kind, or nullptr.
const PlacedRow* find_parameter(ObjectKind kind, std::uint16_t number) noexcept;

/// The parameter of @p kind that is written as "p1120" or "r0333", or nullptr.
const ParameterRow* find_parameter(ObjectKind kind, std::string_view text) noexcept;

}  // namespace drive
