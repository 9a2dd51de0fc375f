#pragma once

#include <array>
#include <cstdint>

#include <gtest/gtest.h>

#include "drive/drive_unit.hpp"
#include "tests/drive/test_drive_unit.hpp"

namespace drive {

/// A unit of two servo axes without a bus: the test puts words where the bus would, and wires inputs.
struct WiredUnit : TestUnit {
  std::array<bool, 2> awake{true, true};

  Axis& axis(std::uint8_t object) { return unit.axes()[object - kX]; }
  /// Puts @p value into word @p place (from 0) that drive object @p object receives.
  void receives(std::uint8_t object, std::size_t place, std::uint16_t value) {
    unit.object(object)->process_data().received[place] = value;
  }
  void receives_double_word(std::uint8_t object, std::size_t place, std::uint32_t value) {
    ProcessDataImage::set_double_word(unit.object(object)->process_data().received, place, value);
  }
  /// Connects input @p number of @p object; a refusal fails the test.
  void wire(std::uint8_t object, std::uint16_t number, const BicoSource& source, std::size_t index = 0) {
    EXPECT_EQ(write(object, number, pack(source), index), std::nullopt) << "p" << number;
  }
  /// Connects input @p number to the constant 0 or 1.
  void set(std::uint8_t object, std::uint16_t number, bool one) {
    EXPECT_EQ(write(object, number, one ? 1.0 : 0.0), std::nullopt) << "p" << number;
  }
  void cycles(int count = 1) {
    for (int i = 0; i < count; ++i) unit.cycle(awake, kCycle);
  }
  /// Sends @p controlword to @p object for two cycles.
  void command(std::uint8_t object, std::uint16_t controlword) {
    receives(object, 0, controlword);
    cycles(2);
  }
  void switch_on(std::uint8_t object) {
    for (const int word : {0x0006, 0x0007, 0x000F}) command(object, static_cast<std::uint16_t>(word));
    EXPECT_EQ(state(object), State::OperationEnabled);
  }
  double rpm(std::uint8_t object) { return axis(object).actual().speed / kRpm; }
};

}  // namespace drive
