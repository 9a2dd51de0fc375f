#include <cstdlib>

#include "tests/device/test_unit.hpp"

namespace device {
namespace {

// Masks of CiA 402 for the state in the statusword.
constexpr std::uint16_t kState = 0x6F;
constexpr std::uint16_t kInhibited = 0x4F;  // Switch on disabled and Fault do not show bit 5

/// Ramps of half a second from and to 3000 rpm; OFF3 twice as fast.
Configuration quick_unit() {
  return unit_with({{1082, 3000.0}, {1120, 0.5}, {1121, 0.5}, {1135, 0.25}});
}

TEST(Sequence, IsShownInEveryTpdoFromSwitchOnDisabledToOperationEnabled) {
  TestUnit unit;

  EXPECT_EQ(unit.start_operational(), at_rest(0x1640));
  EXPECT_EQ(unit.cycles_with("205#0600"), at_rest(0x1631));
  EXPECT_EQ(unit.cycles_with("205#0700"), at_rest(0x1633));
  EXPECT_EQ(unit.cycles_with("205#0F00"), at_rest(0x1637));
}

TEST(Sequence, GoesTheWholeWayBack) {
  TestUnit unit;
  unit.enable();

  EXPECT_EQ(unit.cycles_with("205#0700"), at_rest(0x1633));
  EXPECT_EQ(unit.cycles_with("205#0600"), at_rest(0x1631));
  EXPECT_EQ(unit.cycles_with("205#0000"), at_rest(0x1640));
}

TEST(Sequence, DoesNotLeaveSwitchOnDisabledWithoutTheShutdownCommand) {
  TestUnit unit;
  unit.start_operational();

  EXPECT_EQ(unit.cycles_with("205#0F00"), at_rest(0x1670));
  EXPECT_EQ(unit.passes(1s), Lines{});
}

TEST(Sequence, RunsInPreOperationalOverSdo) {
  TestUnit unit;
  unit.start();

  for (const std::uint32_t controlword : {0x06U, 0x07U, 0x0FU}) {
    EXPECT_EQ(unit.download(0x6040, 0, controlword, 2), 0U);
    EXPECT_EQ(unit.passes(Device::kCycle), Lines{});
  }

  EXPECT_EQ(unit.statusword(), 0x1637);
}

TEST(Sequence, IgnoresRpdosOutsideOperational) {
  TestUnit unit;
  unit.start();

  EXPECT_EQ(unit.says("205#0600"), Lines{});
  unit.passes(100ms);

  EXPECT_EQ(unit.statusword(), 0x1640);
  EXPECT_EQ(unit.upload(0x6040).number(), 0U);
}

TEST(QuickStop, BrakesOnItsOwnRampAndEndsInSwitchOnDisabled) {
  TestUnit unit{quick_unit()};
  unit.turn_at(3000, 1s);

  unit.cycles_with("205#0B00");
  EXPECT_EQ(unit.statusword() & kState, 0x07);
  unit.passes(121ms);  // half of 250 ms, from the cycle before
  EXPECT_NEAR(unit.velocity(), bus_speed(1500), bus_speed(100));
  EXPECT_EQ(unit.statusword() & kState, 0x07);

  EXPECT_TRUE(unit.reaches(kInhibited, 0x40, 200ms));
  EXPECT_LT(std::abs(unit.velocity()), bus_speed(20));
}

TEST(QuickStop, CannotBeCancelled) {
  TestUnit unit{quick_unit()};
  unit.turn_at(3000, 1s);
  unit.cycles_with("205#0B00");

  unit.cycles_with("205#0F00");

  EXPECT_EQ(unit.statusword() & 0x4F, 0x07);
  EXPECT_TRUE(unit.reaches(kInhibited, 0x40, 400ms));
}

TEST(Off1, StaysInOperationEnabledUntilStandstillAndThenIsReady) {
  TestUnit unit{quick_unit()};
  unit.turn_at(3000, 1s);

  unit.cycles_with("205#0600");
  EXPECT_EQ(unit.statusword() & kState, 0x27);
  unit.passes(246ms);
  EXPECT_NEAR(unit.velocity(), bus_speed(1500), bus_speed(100));
  EXPECT_EQ(unit.statusword() & kState, 0x27);

  EXPECT_TRUE(unit.reaches(kState, 0x21, 400ms));
  EXPECT_LT(std::abs(unit.velocity()), bus_speed(20));
}

TEST(Off1, IsTakenBackByEnableOperation) {
  TestUnit unit{quick_unit()};
  unit.turn_at(3000, 1s);
  unit.cycles_with("205#0600");
  unit.passes(200ms);

  unit.cycles_with("205#0F00");
  unit.passes(1s);

  EXPECT_EQ(unit.statusword() & kState, 0x27);
  EXPECT_NEAR(unit.velocity(), bus_speed(3000), bus_speed(3));
}

TEST(DisableOperation, SwitchesThePulsesOffAtOnceAndLetsTheMotorCoast) {
  TestUnit unit{quick_unit()};
  unit.turn_at(3000, 1s);

  unit.cycles_with("205#0700");
  EXPECT_EQ(unit.statusword() & kState, 0x23);
  EXPECT_EQ(unit.upload(0x6077).number(), 0U);

  unit.passes(100ms);
  EXPECT_LT(unit.velocity(), bus_speed(2950));  // friction only
  EXPECT_GT(unit.velocity(), bus_speed(2800));
  EXPECT_EQ(unit.statusword() & kState, 0x23);
}

TEST(DisableVoltage, LeadsToSwitchOnDisabledAtOnceAndLetsTheMotorCoast) {
  TestUnit unit{quick_unit()};
  unit.turn_at(3000, 1s);

  unit.cycles_with("205#0D00");

  EXPECT_EQ(unit.statusword() & kInhibited, 0x40);
  EXPECT_EQ(unit.upload(0x6077).number(), 0U);
  unit.passes(100ms);
  EXPECT_GT(unit.velocity(), bus_speed(2800));
}

TEST(Halt, HasNoFunctionInANewUnit) {
  TestUnit unit{quick_unit()};
  unit.turn_at(3000, 1s);

  unit.cycles_with("205#0F01");
  unit.passes(1s);

  EXPECT_NEAR(unit.velocity(), bus_speed(3000), bus_speed(3));
}

/// An option code of 605Dh with the time from 3000 rpm to standstill (s).
struct HaltOption {
  std::uint32_t code;
  double time;
};
/// How GoogleTest names a case.
void PrintTo(const HaltOption& c, std::ostream* out) {  // NOLINT(readability-identifier-naming): GoogleTest's name
  *out << "option " << c.code;
}
class HaltOptions : public testing::TestWithParam<HaltOption> {};

TEST_P(HaltOptions, StopOnTheirRampAndStayInOperationEnabled) {
  TestUnit unit{quick_unit()};
  unit.turn_at(3000, 1s);
  ASSERT_EQ(unit.download(0x605D, 0, GetParam().code, 2), 0U);

  unit.cycles_with("205#0F01");
  const auto half =
      std::chrono::duration_cast<canopen::Duration>(std::chrono::duration<double>{GetParam().time / 2});
  unit.passes(half - 4ms);
  EXPECT_NEAR(unit.velocity(), bus_speed(1500), bus_speed(150));
  EXPECT_EQ(unit.statusword() & kState, 0x27);
  unit.passes(half + 200ms);
  EXPECT_NEAR(unit.velocity(), 0, bus_speed(1));
  EXPECT_EQ(unit.statusword() & kState, 0x27);

  unit.cycles_with("205#0F00");
  unit.passes(1s);
  EXPECT_NEAR(unit.velocity(), bus_speed(3000), bus_speed(3));
}

INSTANTIATE_TEST_SUITE_P(Sequence, HaltOptions, testing::Values(HaltOption{1, 0.5}, HaltOption{2, 0.25}),
                         [](const auto& option) { return "Code" + std::to_string(option.param.code); });

TEST(Halt, WithOptionThreeStopsAtTheTorqueLimitAndStaysInOperationEnabled) {
  Configuration configuration = quick_unit();
  configuration.axes[0].presets.push_back({2003, 50.0});  // 6077h saturates at twice the reference torque
  TestUnit unit{configuration};
  unit.turn_at(3000, 1s);
  ASSERT_EQ(unit.download(0x605D, 0, 3, 2), 0U);

  unit.cycles_with("205#0F01");
  unit.passes(Device::kCycle);
  const auto torque = static_cast<std::int16_t>(static_cast<std::uint16_t>(unit.upload(0x6077).number()));
  EXPECT_NEAR(torque, -4795, 250);  // 35 N·m of 7.3 N·m when warm
  unit.passes(80ms);                // 13.5 ms for 0.00151 kg·m² at 3000 rpm, and time to settle

  EXPECT_NEAR(unit.velocity(), 0, bus_speed(3));
  EXPECT_EQ(unit.statusword() & kState, 0x27);
}

TEST(Halt, WithOptionZeroSwitchesThePulsesOffWhileItLasts) {
  TestUnit unit{quick_unit()};
  unit.turn_at(3000, 1s);
  ASSERT_EQ(unit.download(0x605D, 0, 0, 2), 0U);

  unit.cycles_with("205#0F01");
  EXPECT_EQ(unit.statusword() & kState, 0x23);
  EXPECT_EQ(unit.upload(0x6077).number(), 0U);

  unit.cycles_with("205#0F00");
  EXPECT_EQ(unit.statusword() & kState, 0x27);
}

}  // namespace
}  // namespace device
