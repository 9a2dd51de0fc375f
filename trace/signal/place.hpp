#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "drive/drive_unit.hpp"

namespace trace {

/// Where in a unit: 0 = control unit, 1..8 = axis, kInfeedPlace.
using Place = std::uint8_t;
inline constexpr Place kControlUnitPlace = 0;
inline constexpr Place kInfeedPlace = 0xFF;

/// The place that @p text writes: "0", "1".., "infeed".
std::optional<Place> parse_place(std::string_view text) noexcept;
/// @p place as parse_place() reads it.
std::string place_text(Place place);
/// What is at @p place of @p unit; nullptr if nothing is.
const drive::DriveObject* object_at(const drive::DriveUnit& unit, Place place) noexcept;
/// Where drive object @p object of @p unit is.
Place place_of(const drive::DriveUnit& unit, const drive::DriveObject& object) noexcept;
/// "axis 1", "the control unit", "the infeed".
std::string place_name(Place place);

}  // namespace trace
