#include <bit>

#include "tests/device/storage_fixture.hpp"

namespace device {
namespace {

constexpr std::uint16_t kDeviceFilter = 0x2000 + 9, kPeriod = 0x2000 + 8848;

/// A unit whose p8848 a master sets.
struct TimedUnit : TestUnit {
  explicit TimedUnit(const Configuration& configuration = unit_with({})) : TestUnit{configuration} {
    start();
    open();
  }
  void open() { ASSERT_EQ(download(0x41B6, 0, 1, 2), 0U); }
  /// Writes p8848 in the way that the unit asks for; what it sends when p0009 is left.
  Lines set_period(float milliseconds) {
    EXPECT_EQ(download(kDeviceFilter, 0, 3, 2), 0U);
    EXPECT_EQ(download(kPeriod, 0, std::bit_cast<std::uint32_t>(milliseconds), 4), 0U);
    return says("605#2B09200000000000");
  }
};

TEST(CyclePeriod, ComesIntoForceWithTheRestartWhenP0009IsLeft) {
  TimedUnit unit;
  ASSERT_EQ(unit.download(kPeriod, 0, 0x3F800000, 4), 0x08000022U) << "wants p0009 = 3";
  ASSERT_EQ(unit.download(kDeviceFilter, 0, 3, 2), 0U);
  ASSERT_EQ(unit.download(kPeriod, 0, 0x3F800000, 4), 0U);
  EXPECT_EQ(unit.device.cycle(), 4ms);

  EXPECT_EQ(unit.says("605#2B09200000000000"), (Lines{"585#6009200000000000", "705#00"}));

  EXPECT_EQ(unit.device.cycle(), 1ms);
  EXPECT_EQ(unit.upload(kPeriod).number(), 0x3F800000U);
  EXPECT_EQ(unit.device.node().state(), canopen::NmtState::PreOperational);
}

TEST(CyclePeriod, OfTheSameLengthRestartsNothing) {
  TimedUnit unit;

  EXPECT_EQ(unit.set_period(4.0F), Lines{"585#6009200000000000"});
}

TEST(CyclePeriod, KeepsParametersAndObjectsThroughTheRestart) {
  TimedUnit unit;
  ASSERT_EQ(unit.download(0x1800, 2, 1, 1), 0U);
  ASSERT_EQ(unit.download(0x1029, 1, 2, 1), 0U);

  unit.set_period(2.0F);

  EXPECT_EQ(unit.upload(0x1800, 2).number(), 1U);
  EXPECT_EQ(unit.upload(0x1029, 1).number(), 2U);
}

TEST(CyclePeriod, RestartsFromOperationalWithoutAFault) {
  TimedUnit unit;
  unit.says("000#0105");
  unit.passes(100ms);

  EXPECT_EQ(from("085#", unit.set_period(1.0F)), Lines{});

  EXPECT_EQ(unit.device.node().state(), canopen::NmtState::PreOperational);
  EXPECT_EQ(unit.upload(0x1003, 0).number(), 0U);
}

TEST(CyclePeriod, IsTheTimeBetweenTwoCycles) {
  for (const float milliseconds : {1.0F, 2.0F, 16.0F}) {
    TimedUnit unit;
    unit.set_period(milliseconds);
    const canopen::Duration period = CycleClock::period_of(milliseconds);
    unit.says("000#0105");
    unit.passes(period * 10);

    for (const char* const word : {"205#0600", "205#0700", "205#0F00"}) {
      unit.says(word);
      EXPECT_LE(unit.device.next_deadline() - unit.now, period);
      unit.passes(period);
    }
    ASSERT_EQ(unit.statusword() & 0x6F, 0x27) << milliseconds;
    unit.passes(unit.device.next_deadline() - unit.now);
    EXPECT_EQ(unit.device.next_deadline() - unit.now, period);
  }
}

TEST(CyclePeriod, LetsTheSameTimePassForTheMotor) {
  std::vector<std::int32_t> velocities;
  for (const float milliseconds : {1.0F, 4.0F, 10.0F}) {
    TimedUnit unit{unit_with({{1120, 1.0}})};
    unit.set_period(milliseconds);
    unit.says("000#0105");
    unit.passes(100ms);
    for (const char* const word : {"205#0600", "205#0700", "205#0F00"}) {
      unit.says(word);
      unit.passes(20ms);
    }
    unit.says("305#0F000000800C");
    unit.passes(200ms);
    velocities.push_back(unit.velocity());
  }
  EXPECT_NEAR(velocities[0], velocities[1], bus_speed(3000) / 100);
  EXPECT_NEAR(velocities[2], velocities[1], bus_speed(3000) / 100);
}

TEST(CyclePeriod, BoundsTheTimeThatALateUnitMakesUpFor) {
  TimedUnit unit;
  unit.set_period(1.0F);
  unit.says("000#0105");
  unit.passes(100ms);
  for (const char* const word : {"205#0600", "205#0700", "205#0F00"}) {
    unit.says(word);
    unit.passes(4ms);
  }

  unit.now += 1s;
  unit.device.on_time(unit.now);

  EXPECT_EQ(unit.device.skipped_cycles(), 900U);
}

TEST(CyclePeriod, DecidesHowManyTpdosMayBeValid) {
  TimedUnit unit{{.node_id = 5, .axes = std::vector<AxisSetup>(8)}};
  constexpr std::uint16_t kRemaining = 0x2000 + 8742;
  EXPECT_EQ(unit.upload(kRemaining, 1).number(), 28U);

  unit.set_period(2.0F);
  EXPECT_EQ(unit.upload(kRemaining, 1).number(), 12U);
}

TEST(CyclePeriod, MakesTpdosBeyondTheirNumberInvalid) {
  TimedUnit unit{{.node_id = 5, .axes = std::vector<AxisSetup>(4)}};
  for (std::uint16_t axis = 1; axis < 4; ++axis)
    for (std::uint16_t place = 0; place < 4; ++place)
      ASSERT_EQ(unit.download(static_cast<std::uint16_t>(0x1800 + 0x40 * axis + place), 1,
                              0x40000300U + 0x10U * axis + place, 4),
                0U);

  unit.set_period(1.0F);

  EXPECT_EQ(unit.upload(0x1843, 1).number(), 0x40000313U) << "the eighth";
  EXPECT_EQ(unit.upload(0x1880, 1).number(), 0xC0000320U) << "the ninth";
  EXPECT_EQ(unit.upload(0x1003, 3 + 72).number() >> 16, 8758U);
}

TEST(CyclePeriod, IsKeptThroughAPowerCut) {
  TimedUnit unit;
  unit.set_period(2.0F);
  ASSERT_EQ(unit.download(0x1010, 1, 0x65766173, 4), 0U);

  TestUnit next;
  ASSERT_TRUE(next.device.load_parameters(unit.listener.image));
  next.start();

  EXPECT_EQ(next.device.cycle(), 2ms);
}

TEST(CyclePeriod, ThatWasNotStoredIsGoneAfterAResetOfTheNode) {
  TimedUnit unit;
  unit.set_period(2.0F);

  unit.says("000#8205");
  EXPECT_EQ(unit.device.cycle(), 2ms) << "no parameter of the communication objects";
  unit.says("000#8105");
  EXPECT_EQ(unit.device.cycle(), 4ms);
}

TEST(CyclePeriod, MayBeConfigured) {
  TestUnit unit{{.node_id = 5, .presets = {{8848, 2.0}}}};
  unit.start();
  EXPECT_EQ(unit.device.cycle(), 2ms);

  unit.says("000#8105");

  EXPECT_EQ(unit.device.cycle(), 2ms);
}

TEST(CyclePeriod, BecomesThatOfANewUnitWithTheFactoryValues) {
  TimedUnit unit;
  unit.set_period(2.0F);

  ASSERT_EQ(unit.download(0x1011, 1, 0x64616F6C, 4), 0U);

  EXPECT_EQ(unit.device.cycle(), 4ms);
}

}  // namespace
}  // namespace device
