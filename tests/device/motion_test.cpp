#include <algorithm>
#include <cmath>

#include "libcanopen/base/little_endian.hpp"
#include "tests/device/test_unit.hpp"

namespace device {
namespace {

constexpr double kSlope = 7200.0 / 10.0;  // p1082 by p1120 of a new unit (rpm/s)

/// Velocity actual value in the last 285# of @p lines.
double velocity_in(const Lines& lines) {
  const Lines frames = from("285#", lines);
  if (frames.empty()) return NAN;
  const canopen::Frame frame = fakes::frame_of(frames.back());
  return canopen::load<std::int32_t>(&frame.data[2]);
}

TEST(Velocity, FollowsTheRampOfP1120AndSettlesAtTheTarget) {
  TestUnit unit;
  unit.enable();
  unit.passes(100ms);

  EXPECT_EQ(unit.says("305#0F000000800C"), Lines{});
  double seconds = 0.0;
  while (kSlope * seconds < 3000.0) {
    const double velocity = velocity_in(unit.passes(Device::kCycle));
    seconds += 0.004;
    ASSERT_LE(velocity, bus_speed(kSlope * seconds)) << seconds << " s";
    ASSERT_GE(velocity, bus_speed(kSlope * (seconds - 0.008))) << seconds << " s";
  }
  EXPECT_NEAR(seconds, 3000.0 / kSlope, 0.004);

  unit.passes(100ms);
  for (int i = 0; i < 250; ++i) {
    unit.passes(Device::kCycle);
    ASSERT_NEAR(unit.velocity(), 209715200, 209715);
  }
}

TEST(Velocity, DemandIsTheRampExactly) {
  TestUnit unit;
  unit.enable();

  unit.says("305#0F000000800C");
  for (int cycle = 1; cycle <= 1100; ++cycle) {
    unit.passes(Device::kCycle);
    const double rpm = std::min(3000.0, kSlope * 0.004 * cycle);
    const auto demand = static_cast<std::int32_t>(static_cast<std::uint32_t>(unit.upload(0x606B).number()));
    ASSERT_NEAR(demand, bus_speed(rpm), 1.0) << "cycle " << cycle;
  }
}

TEST(Velocity, TurnsBackwardsWithANegativeTarget) {
  TestUnit unit{unit_with({{1120, 0.1}})};
  unit.enable();

  unit.says("305#0F00000080F3");
  unit.passes(1s);

  EXPECT_NEAR(unit.velocity(), -209715200, 209715);
  EXPECT_LT(static_cast<std::int32_t>(static_cast<std::uint32_t>(unit.upload(0x6063).number())), 0);
}

TEST(Velocity, IsLimitedToP1082) {
  TestUnit unit{unit_with({{1082, 3000.0}, {1120, 0.1}})};
  unit.enable();

  unit.says("305#0F000000803E");  // 15000 rpm
  unit.passes(1s);

  EXPECT_NEAR(unit.velocity(), 209715200, 209715);
}

TEST(Position, MovesByWhatTheVelocitySays) {
  TestUnit unit{unit_with({{1120, 0.1}})};
  unit.turn_at(60, 1s);
  const std::uint64_t before = unit.upload(0x6063).number();

  unit.passes(1s);

  EXPECT_NEAR(static_cast<double>(unit.upload(0x6063).number() - before), kRevolution, 0.001 * kRevolution);
}

TEST(Torque, ShowsTheLoadInPerMilleOfTheRatedTorque) {
  TestUnit unit{unit_with({{1120, 0.1}})};
  unit.turn_at(3000, 1s);
  const auto friction = static_cast<double>(unit.upload(0x6077).number());

  unit.device.set_load_torque(1, 3.65, unit.now);  // half of 7.3 N·m
  unit.passes(1s);

  EXPECT_NEAR(friction, 22, 1);  // (0.1 N·m + 0.0002 N·m·s · 314 /s) / 7.3 N·m
  EXPECT_NEAR(static_cast<double>(unit.upload(0x6077).number()), 500 + friction, 1);
  EXPECT_NEAR(static_cast<double>(unit.upload(0x6074).number()), 500 + friction, 1);
  EXPECT_NEAR(unit.velocity(), 209715200, 209715);
}

TEST(Statusword, ShowsTargetReachedAndStandstill) {
  TestUnit unit{unit_with({{1120, 1.0}})};
  unit.enable();
  EXPECT_EQ(unit.statusword() & 0x1400, 0x1400);

  unit.says("305#0F000000800C");
  unit.passes(300ms);
  EXPECT_EQ(unit.statusword() & 0x1400, 0x0000);
  unit.passes(1s);
  EXPECT_EQ(unit.statusword() & 0x1400, 0x0400);
}

}  // namespace
}  // namespace device
