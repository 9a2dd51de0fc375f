#include "tests/profidrive/if1_unit.hpp"

namespace profidrive {
namespace {

using Pzd = If1Unit;

TEST(If1Words, SwitchTheAxisOn) {
  If1Unit unit;
  unit.set(922, 1.0);
  EXPECT_EQ(unit.exchange({0x047E, 0}, 200ms), (Words{0xEB31, 0}));
  EXPECT_EQ(unit.exchange({0x047F, 0}, 2s), (Words{0xEB37, 0}));
}

TEST(If1Words, LeadTheSpeed) {
  for (const auto& configuration : {Pzd::servo(), Pzd::servo_without_channel(), Pzd::vector()}) {
    If1Unit unit{configuration};
    unit.set(922, 1.0);
    unit.exchange({0x047E, 0}, 200ms);
    const Words sent = unit.exchange({0x047F, 0x1000}, 15s);
    EXPECT_EQ(sent[0], 0xEF37);
    EXPECT_NEAR(sent[1], 0x1000, 0x29);
  }
}

TEST(If1Words, WithoutEnableOperationLeaveThePulsesOff) {
  If1Unit unit;
  unit.set(922, 1.0);
  unit.exchange({0x047E, 0}, 200ms);
  EXPECT_EQ(unit.exchange({0x0477, 0}, 2s), (Words{0xEB33, 0}));
}

TEST(If1Words, ActFromTheStartOfTheNextCycle) {
  If1Unit unit;
  unit.if1.receive(Pzd::kAxis, Words{0x0400, 0x1234});
  EXPECT_EQ(unit.read(2050, 1), 0.0);
  unit.passes(4ms);
  EXPECT_EQ(unit.read(2050, 0), 0x0400);
  EXPECT_EQ(unit.read(2050, 1), 0x1234);
  EXPECT_EQ(unit.read(2060, 0), 0x04001234);
  EXPECT_EQ(unit.read(2090), 0x0400);
  EXPECT_EQ(unit.read(2091), 0x1234);
}

TEST(If1Words, ThatADriveObjectDoesNotHaveAreDropped) {
  If1Unit unit;
  unit.if1.receive(Pzd::kAxis, Words(32, 0xFFFF));
  unit.passes(4ms);
  EXPECT_EQ(unit.if1.received(Pzd::kAxis).size(), 20U);
  EXPECT_EQ(unit.read(2050, 19), -1.0);
  If1Unit vector{Pzd::vector()};
  vector.if1.receive(Pzd::kAxis, Words(32, 0xFFFF));
  vector.passes(4ms);
  EXPECT_EQ(vector.read(2050, 31), -1.0);
}

TEST(If1Words, StayWithoutControlByPlc) {
  If1Unit unit;
  unit.exchange({0x0401, 0x1000}, 20ms);
  unit.exchange({0x00FF, 0x2000}, 20ms);
  EXPECT_EQ(unit.read(2050, 0), 0x0001);
  EXPECT_EQ(unit.read(2050, 1), 0x1000);

  unit.set(2037, 2.0);
  unit.exchange({0x00FF, 0x2000}, 20ms);
  EXPECT_EQ(unit.read(2050, 0), 0x00FF);
  EXPECT_EQ(unit.read(2050, 1), 0x2000);
}

TEST(If1Words, OfTheControlUnitActWithoutControlByPlc) {
  If1Unit unit;
  unit.exchange({0x0002, 0x1000}, 20ms, Pzd::kControlUnit);
  EXPECT_EQ(unit.read(2050, 0, Pzd::kControlUnit), 2.0);
  EXPECT_EQ(unit.read(2050, 1, Pzd::kControlUnit), 0x1000);
}

TEST(If1Words, LosingControlByPlcInOperationIsAFault) {
  If1Unit unit;
  unit.set(922, 1.0);
  unit.exchange({0x047E, 0}, 200ms);
  unit.exchange({0x047F, 0}, 1s);
  unit.exchange({0x007F, 0}, 100ms);
  EXPECT_TRUE(unit.has_fault(7220));
}

TEST(If1Words, ComeWithFreeWiringToo) {
  If1Unit unit;
  unit.set(2051, own(2050, 4), 3);
  unit.set(2061, own(2060, 2), 5);
  unit.set(2080, own(2092, 1), 7);
  unit.set(2051, own(2089, 0), 0);
  unit.set(2099, own(2050, 4), 1);
  const Words sent = unit.exchange({0x0400, 0, 0x1002, 0x0304, 0x5566}, 20ms);
  EXPECT_EQ(sent[0], 0x0080);
  EXPECT_EQ(sent[3], 0x5566);
  EXPECT_EQ(unit.sent(7)[5], 0x1002);
  EXPECT_EQ(unit.sent(7)[6], 0x0304);
  EXPECT_EQ(unit.read(2095), 0x5566);
  EXPECT_EQ(unit.read(2053, 3), 0x5566);
  EXPECT_EQ(unit.read(2063, 5), 0x10020304);
  EXPECT_EQ(unit.read(2067, 0), 5.0);
  EXPECT_EQ(unit.read(2067, 1), 7.0);
  EXPECT_EQ(unit.read(2075, 4), 8.0);
  EXPECT_EQ(unit.read(2075, 5), 65535.0);
  EXPECT_EQ(unit.read(2076, 6), 12.0);
  EXPECT_EQ(unit.read(2074, 0), 65535.0);
}

TEST(If1Words, AreInvertedAsAsked) {
  If1Unit unit;
  unit.set(2051, own(2089, 1), 0);
  unit.set(2088, 0x8001, 1);
  unit.set(2098, 0x00F0, 0);
  EXPECT_EQ(unit.exchange({0x0400}, 20ms)[0], 0x8001);
  EXPECT_EQ(unit.read(2094), 0x00F0);
}

TEST(If1Words, ReachAcrossDriveObjects) {
  If1Unit unit;
  unit.set(2051, drive::pack({2050, Pzd::kAxis, 6}), 2, Pzd::kSecondAxis);
  unit.exchange({0x0400, 0, 0, 0, 0, 0, 0x4321}, 20ms);
  EXPECT_EQ(unit.sent(3, Pzd::kSecondAxis)[2], 0x4321);
}

TEST(If1Words, TakeTheAxisAwayFromTheCanBus) {
  If1Unit unit;
  unit.set(922, 1.0);
  unit.runner.unit().axes()[0].process_data().received[0] = 0x0006;
  unit.exchange({0x047E, 0}, 200ms);
  unit.runner.unit().axes()[0].process_data().received[0] = 0x000F;
  EXPECT_EQ(unit.exchange({0x047E, 0}, 200ms)[0], 0xEB31);
}

TEST(If1Cycle, IsThatOfP2048) {
  If1Unit unit;
  unit.set(2048, 16.0, 0, Pzd::kControlUnit);
  unit.exchange({0x0400, 1}, 100ms);
  int changes = 0;
  double before = unit.read(2050, 1);
  for (std::uint16_t i = 2; i < 42; ++i) {
    unit.if1.receive(Pzd::kAxis, Words{0x0400, i});
    unit.passes(4ms);
    changes += unit.read(2050, 1) != before ? 1 : 0;
    before = unit.read(2050, 1);
  }
  EXPECT_EQ(changes, 10);
}

/// Telegram 2 with the sign of life in STW2.
struct SignOfLifeUnit : If1Unit {
  SignOfLifeUnit() { set(922, 2.0); }
  /// The life signs @p values one after the other; the last one that is sent back.
  unsigned live(std::initializer_list<unsigned> values) {
    for (const unsigned value : values) exchange({0x047E, 0, 0, static_cast<std::uint16_t>(value << 12)}, 4ms);
    return sent(4)[3] >> 12;
  }
};

TEST(SignOfLife, IsSentOnceThatOfTheControllerRuns) {
  SignOfLifeUnit unit;
  EXPECT_EQ(unit.live({0, 0, 0}), 0U);
  const unsigned first = unit.live({1});
  EXPECT_EQ(unit.live({2}), first % 15 + 1);
  EXPECT_EQ(unit.live({3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 1}), (first + 15 - 1) % 15 + 1);
  EXPECT_FALSE(unit.has_fault(1912));
}

TEST(SignOfLife, ThatFailsMoreOftenThanAllowedIsAFault) {
  SignOfLifeUnit unit;
  unit.live({1, 2, 2});
  EXPECT_FALSE(unit.has_fault(1912));
  unit.live({2});
  EXPECT_TRUE(unit.has_fault(1912));
  EXPECT_EQ(unit.read(2065), 2.0);
}

TEST(SignOfLife, IsSynchronousAgainAfterFifteenGoodValues) {
  SignOfLifeUnit unit;
  unit.live({1, 1, 1});
  ASSERT_TRUE(unit.has_fault(1912));
  unit.runner.acknowledge(1, unit.runner.now());
  unit.live({2, 3, 3, 3});
  EXPECT_FALSE(unit.has_fault(1912));
  unit.live({4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 1, 2, 3});
  unit.live({3, 3});
  EXPECT_TRUE(unit.has_fault(1912));
}

TEST(SignOfLife, IsNotMonitoredIfP0925SaysSo) {
  SignOfLifeUnit unit;
  unit.set(925, 65535.0);
  unit.live({1, 1, 1, 1, 1, 1});
  EXPECT_FALSE(unit.has_fault(1912));
}

TEST(SignOfLife, GoesOnWithoutControlByPlcUnlessThatFreezesIt) {
  SignOfLifeUnit unit;
  unit.exchange({0x0000, 0, 0, 0x1000}, 8ms);
  EXPECT_EQ(unit.read(2050, 3), 0x1000);
  unit.set(2037, 1.0);
  unit.exchange({0x0000, 0, 0, 0x2000}, 8ms);
  EXPECT_EQ(unit.read(2050, 3), 0x1000);
}

}  // namespace
}  // namespace profidrive
