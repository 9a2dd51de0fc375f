#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

/// The offset rule of the object catalogue: where an axis has the objects that axis 1 has. It stands here alone,
/// for the data sheets, for the dictionary that is served and for the objects that the unit names; so it includes
/// nothing.
namespace eds {

/// Objects of axis 1 from `first` to `last`; axis n has them (n - 1) times `offset` higher.
struct AxisOffset {
  std::uint16_t first = 0;
  std::uint16_t last = 0;
  std::uint16_t offset = 0;
};

/// From axis to axis the object @p index of axis 1 goes up by so much, 0 if the unit has it once.
constexpr std::uint16_t stride_of(std::span<const AxisOffset> offsets, std::uint16_t index) noexcept {
  const auto row = std::ranges::find_if(
      offsets, [=](const AxisOffset& offset) { return index >= offset.first && index <= offset.last; });
  return row != offsets.end() ? row->offset : std::uint16_t{0};
}

/// How much higher axis @p axis (from 1) has the object @p index of axis 1.
constexpr std::uint16_t axis_offset(std::span<const AxisOffset> offsets, std::uint16_t index,
                                    std::size_t axis) noexcept {
  return static_cast<std::uint16_t>(stride_of(offsets, index) * (axis - 1));
}

/// Whether sub-index @p sub_index of object @p index names an object that a PDO maps.
constexpr bool is_mapping_entry(std::uint16_t index, std::uint8_t sub_index) noexcept {
  constexpr std::uint16_t kReceive = 0x1600, kTransmit = 0x1A00, kRecords = 0x200;
  const bool mapping =
      (index >= kReceive && index < kReceive + kRecords) || (index >= kTransmit && index < kTransmit + kRecords);
  return mapping && sub_index != 0;
}

/// The initial value @p initial that entry @p index, @p sub_index has on axis 1, on axis @p axis: a mapping names
/// the object of its own axis there.
constexpr std::int64_t initial_on_axis(std::span<const AxisOffset> offsets, std::uint16_t index,
                                       std::uint8_t sub_index, std::int64_t initial, std::size_t axis) noexcept {
  constexpr unsigned kIndexShift = 16;
  if (!is_mapping_entry(index, sub_index) || initial == 0) return initial;
  const auto mapped = static_cast<std::uint16_t>(initial >> kIndexShift);
  return initial + (std::int64_t{axis_offset(offsets, mapped, axis)} << kIndexShift);
}

}  // namespace eds
