// A resting axis takes up every input of positioning.
#include <array>
#include <variant>

#include <gtest/gtest.h>

#include "tests/drive/positioning/positioning_unit.hpp"

namespace drive {
namespace {

constexpr std::uint16_t kBits = 8891;        // r8891, of the second received word
constexpr std::uint16_t kDoubleWord = 8860;  // r8860[4], of the fifth and sixth
constexpr std::size_t kBitsPlace = 1;
constexpr std::size_t kDoubleWordPlace = 4;

bool is_of_positioning(BlockId block) {
  return block == kBlock<ActualPosition> || block == kBlock<Positioner> || block == kBlock<PositionControl>;
}

/// Rests with its pulses off until the bus brings something new.
struct RestingUnit : PositioningUnit {
  /// Cycles in which nothing but what is new wakes the axis.
  void pass(int cycles) {
    constexpr std::array kAsleep{false};
    for (int i = 0; i < cycles; ++i) unit.cycle(kAsleep, kMillisecond);
  }
  void come_to_rest() {
    run(5);
    pass(20);
    EXPECT_TRUE(axis().is_quiescent());
  }
};

TEST(PositionerWakeUp, FollowsEveryBinector) {
  std::size_t inputs = 0;
  for (const PlacedRow& placed : parameters_of(ObjectKind::Servo)) {
    const auto* const input = std::get_if<BitInput>(&placed.row->home);
    if (input == nullptr || !is_of_positioning(input->block)) continue;
    SCOPED_TRACE(parameter_text(*placed.row));
    RestingUnit unit;
    unit.wire(placed.row->number, {kBits, kOwnObject, 0});
    unit.come_to_rest();
    for (const bool level : {true, false}) {
      unit.axis().process_data().received[kBitsPlace] = level ? 1 : 0;
      unit.pass(2);
      EXPECT_EQ(input->member(unit.axis().block(input->block), 0), level);
    }
    ++inputs;
  }
  EXPECT_GT(inputs, 50U);
}

TEST(PositionerWakeUp, FollowsEveryConnector) {
  std::size_t inputs = 0;
  for (const PlacedRow& placed : parameters_of(ObjectKind::Servo)) {
    const auto* const input = std::get_if<ValueInput>(&placed.row->home);
    if (input == nullptr || !is_of_positioning(input->block)) continue;
    SCOPED_TRACE(parameter_text(*placed.row));
    RestingUnit unit;
    unit.wire(placed.row->number, {kDoubleWord, kOwnObject, kDoubleWordPlace});
    unit.come_to_rest();
    const double before = input->member(unit.axis().block(input->block), 0);
    ProcessDataImage::set_double_word(unit.axis().process_data().received, kDoubleWordPlace, 0x1000);
    unit.pass(2);
    EXPECT_NE(input->member(unit.axis().block(input->block), 0), before);
    ++inputs;
  }
  EXPECT_GT(inputs, 15U);
}

}  // namespace
}  // namespace drive
