#pragma once

#include "drive/drive_unit.hpp"

namespace drive {

inline constexpr std::uint8_t kUnit = kControlUnitNumber;
inline constexpr std::uint8_t kX = 2;
inline constexpr std::uint8_t kY = 3;
inline constexpr double kCycle = 0.004;

inline UnitConfiguration two_axes() {
  return {.axes = {{}, {}}, .node_id = 5};
}

/// A unit of two servo axes and the value types of a master.
struct TestUnit {
  DriveUnit unit;

  explicit TestUnit(ParameterHost* host = nullptr) : unit{two_axes(), host} {}

  double read(std::uint8_t object, std::uint16_t number, std::size_t index = 0) const {
    return decode(unit.read(object, number, index).value());
  }
  /// The refusal of a write, or nothing.
  std::optional<Refusal> write(std::uint8_t object, std::uint16_t number, double value, std::size_t index = 0) {
    const PlacedRow* const placed = find_parameter(unit.object(object)->kind(), number);
    const DataType type = placed != nullptr ? placed->row->type : DataType::U32;
    const auto written = unit.write(object, number, index, encode(type, value));
    return written ? std::nullopt : std::optional{written.error().reason};
  }
  void enable(std::uint8_t object) {
    for (const int word : {0x0006, 0x0006, 0x0007, 0x000F})
      unit.axes()[object - kX].cycle(Setpoints{.controlword = static_cast<std::uint16_t>(word)}, kCycle);
  }
  State state(std::uint8_t object) const { return unit.axes()[object - kX].actual().state; }
};

}  // namespace drive
