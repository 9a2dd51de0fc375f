#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <ranges>
#include <span>

#include "eds/catalogue/axis_rule.hpp"
#include "libcanopen/od/entry_description.hpp"

/// The rows of a generated table on another axis or another kind of device, for every dictionary that is made of
/// one. The other initial values are rows of such a table with index, sub-index and value, under the indices of
/// axis 1.
namespace eds {

/// Gives @p row, still under its index on axis 1, the initial value that @p others has for it, if any.
template <std::ranges::forward_range Others>
constexpr void take_initial(canopen::EntryDescription& row, const Others& others) noexcept {
  const auto other = std::ranges::find_if(
      others, [&](const auto& o) { return o.index == row.index && o.sub_index == row.sub_index; });
  if (other == std::ranges::end(others)) return;
  row.initial = other->initial;
  row.node_relative = false;
}

/// Gives @p row, still under its index on axis 1, the initial value it has on axis @p axis (from 1): mappings name
/// the objects of their own axis, and @p other_axes has what differs from axis 1.
template <std::ranges::forward_range Others>
constexpr void begin_on_axis(canopen::EntryDescription& row, std::span<const AxisOffset> offsets, std::size_t axis,
                             const Others& other_axes) noexcept {
  row.initial = initial_on_axis(offsets, row.index, row.sub_index, row.initial, axis);
  if (axis > 1) take_initial(row, other_axes);
}

/// Gives @p row its index on axis @p axis (from 1).
constexpr void move_to_axis(canopen::EntryDescription& row, std::span<const AxisOffset> offsets,
                            std::size_t axis) noexcept {
  row.index = static_cast<std::uint16_t>(row.index + axis_offset(offsets, row.index, axis));
}

}  // namespace eds
