#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "libcanopen/od/entry_description.hpp"

namespace device {

/// Axes that a unit has at most.
inline constexpr std::size_t kMostAxes = 8;

/// What kind of drive object an axis is.
enum class AxisType : std::uint8_t { Servo, Vector };

/// The entries of a unit with @p axes, ascending by index and sub-index: those of the unit once, those of an axis
/// by the offset rule. Throws std::invalid_argument unless there are 1..kMostAxes.
[[nodiscard]] std::vector<canopen::EntryDescription> object_rows(std::span<const AxisType> axes);

}  // namespace device
