#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "drive/base/object_kind.hpp"
#include "libcanopen/od/entry_description.hpp"

namespace device {

/// How much higher axis @p axis (1..drive::kMostAxes) has the object @p index of axis 1, as the catalogue
/// says; objects of the unit are where they are.
[[nodiscard]] std::uint16_t axis_offset(std::uint16_t index, std::size_t axis) noexcept;

/// The entries of a unit with axes of the kinds @p axes, servo or vector, ascending by index and sub-index: those
/// of the unit once, those of an axis by the offset rule. Throws std::invalid_argument unless there are
/// 1..drive::kMostAxes.
[[nodiscard]] std::vector<canopen::EntryDescription> object_rows(std::span<const drive::ObjectKind> axes);

}  // namespace device
