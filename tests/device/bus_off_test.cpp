#include "tests/device/communication_fixture.hpp"

namespace device {
namespace {

constexpr std::uint16_t kClearBusOff = 0x2000 + 8608;
constexpr std::uint16_t kErrorBehaviour = 0x2000 + 8609;

/// A unit in Operational that has lost the bus.
struct LostUnit : ControlUnit {
  explicit LostUnit(std::size_t axes = 1) : ControlUnit{axes} {
    says("000#0105");
    passes(100ms);
    device.on_bus_state(BusState::Off, now);
  }
};

TEST(BusOff, SilencesTheUnitButForSdoAnswers) {
  LostUnit unit;

  for (const char* const frame : {"080#", "705#R", "000#8005", "205#0600"}) EXPECT_EQ(unit.says(frame), Lines{});
  EXPECT_EQ(unit.passes(1s), Lines{});
  EXPECT_EQ(unit.state(), canopen::NmtState::Operational) << "NMT is not heard";
  EXPECT_EQ(unit.upload(0x6040).number(), 0U) << "nor is an RPDO";
  EXPECT_EQ(unit.says("605#4000100000000000"), Lines{"585#430010009201FFFF"});
}

TEST(BusOff, SilencesHeartbeatAndEmcy) {
  ControlUnit unit;
  ASSERT_EQ(unit.download(0x1017, 0, 100, 2), 0U);
  unit.device.on_bus_state(BusState::Off, unit.now);

  ASSERT_TRUE(unit.device.raise(1, 7860, 0, unit.now));
  EXPECT_EQ(unit.passes(1s), Lines{});

  unit.device.on_bus_state(BusState::Active, unit.now);
  EXPECT_EQ(from("085#", unit.passes(0ms)).size(), 3U);
  EXPECT_EQ(from("705#", unit.passes(1s)).size(), 10U) << "no burst, no gap";
}

TEST(BusOff, IsEndedByP8608WrittenOverSdo) {
  LostUnit unit;

  const Lines lines = unit.says("605#2BA0410001000000");

  EXPECT_EQ(lines.at(0), "585#60A0410000000000");
  EXPECT_EQ(from("085#", lines), (Lines{"085#011011FC21010000", "085#011011FC21020000"}));
  EXPECT_EQ(unit.listener.bus_restarts, 1);
  EXPECT_EQ(unit.upload(kClearBusOff, 0).number(), 0U);
  EXPECT_EQ(unit.says("705#R"), Lines{"705#05"});
  EXPECT_EQ(unit.download(0x1003, 0, 0, 1), 0U);
  EXPECT_EQ(unit.faults(2), Numbers{});
}

/// Ways to acknowledge the faults of the whole unit while the bus is off.
struct AcknowledgedBusOff : testing::TestWithParam<std::vector<std::string_view>> {};

// The order of the manual: acknowledge, then p8608[0] = 1.
TEST_P(AcknowledgedBusOff, IsOverWithTheRestart) {
  LostUnit unit;
  unit.passes(100ms);
  ASSERT_EQ(unit.statusword() & 0x4F, 0x08);

  for (const std::string_view request : GetParam()) EXPECT_EQ(unit.says(request).size(), 1U);
  EXPECT_EQ(unit.faults(2), Numbers{8700}) << "its cause is there";
  EXPECT_EQ(unit.statusword() & 0x4F, 0x08);
  unit.open(1);
  const Lines lines = unit.says("605#2BA0410001000000");
  EXPECT_EQ(lines.at(0), "585#60A0410000000000");
  EXPECT_EQ(from("085#", lines), (Lines{"085#011011FC21010000", "085#011011FC21020000", "085#0000000000000000"}));

  unit.passes(Device::kCycle);
  EXPECT_EQ(unit.faults(1), Numbers{});
  EXPECT_EQ(unit.faults(2), Numbers{});
  EXPECT_EQ(unit.statusword() & 0x4F, 0x40);
  EXPECT_EQ(unit.upload(0x1001).number(), 0U);
  unit.open(2);
  EXPECT_EQ(unit.upload(0x2000 + 945, 0).number(), 0U);
  EXPECT_EQ(unit.upload(0x2000 + 945, 8).number(), 8700U);
}

INSTANTIATE_TEST_SUITE_P(
    Ways, AcknowledgedBusOff,
    testing::Values(std::vector<std::string_view>{"605#2F8D2F0001000000", "605#2BB6410002000000",
                                                  "605#2F8D2F0001000000"},  // p3981 of both drive objects
                    std::vector<std::string_view>{"605#2F03100000000000"}),
    [](const auto& tried) { return tried.param.size() == 1 ? "Object1003" : "P3981"; });

TEST(BusOff, ThatWasAcknowledgedLeavesAnotherFaultInForce) {
  LostUnit unit;
  unit.passes(100ms);
  ASSERT_EQ(unit.download(0x1003, 0, 0, 1), 0U);
  ASSERT_TRUE(unit.device.raise(1, 7901, 0, unit.now));

  unit.says("605#2BA0410001000000");

  EXPECT_EQ(unit.faults(2), Numbers{7901});
  unit.passes(Device::kCycle);
  EXPECT_EQ(unit.statusword() & 0x4F, 0x08);
}

TEST(BusOff, HasToBeAcknowledgedAnewWhenItComesAgain) {
  LostUnit unit;
  unit.passes(100ms);
  ASSERT_EQ(unit.download(0x1003, 0, 0, 1), 0U);
  unit.says("605#2BA0410001000000");
  ASSERT_EQ(unit.faults(2), Numbers{});

  unit.device.on_bus_state(BusState::Off, unit.now);
  unit.says("605#2BA0410001000000");

  EXPECT_EQ(unit.faults(2), Numbers{8700});
}

TEST(BusOff, IsEndedByP8608OnceTheControllerSaysSo) {
  LostUnit unit;
  unit.listener.bus_can_be_used = false;

  ASSERT_EQ(unit.download(kClearBusOff, 0, 1, 2), 0U);
  EXPECT_EQ(unit.passes(10s), Lines{});
  EXPECT_EQ(unit.listener.bus_restarts, 1);

  unit.device.on_bus_state(BusState::Active, unit.now);
  EXPECT_EQ(from("085#", unit.passes(0ms)).size(), 2U);
}

TEST(BusOff, IsTriedToEndEveryTwoSecondsIfP8608SaysSo) {
  ControlUnit unit;
  ASSERT_EQ(unit.download(kClearBusOff, 1, 1, 2), 0U);
  unit.listener.bus_can_be_used = false;
  unit.passes(10s);
  EXPECT_EQ(unit.listener.bus_restarts, 0);
  unit.device.on_bus_state(BusState::Off, unit.now);

  unit.passes(1999ms);
  EXPECT_EQ(unit.listener.bus_restarts, 0);
  unit.passes(1ms);
  EXPECT_EQ(unit.listener.bus_restarts, 1);
  unit.passes(2s);
  EXPECT_EQ(unit.listener.bus_restarts, 2);

  unit.listener.bus_can_be_used = true;
  EXPECT_EQ(from("085#", unit.passes(2s)).size(), 2U);
  unit.passes(10s);
  EXPECT_EQ(unit.listener.bus_restarts, 3);
}

TEST(BusOff, MayBeToldToEndByItselfWhileItLasts) {
  LostUnit unit;
  ASSERT_EQ(unit.download(kClearBusOff, 1, 1, 2), 0U);

  EXPECT_EQ(from("085#", unit.passes(1999ms)), Lines{});
  EXPECT_EQ(from("085#", unit.passes(1ms)).size(), 2U);
}

TEST(BusOff, LastsWithoutP8608) {
  LostUnit unit;

  EXPECT_EQ(unit.passes(1h), Lines{});
  EXPECT_EQ(unit.listener.bus_restarts, 0);
}

TEST(BusOff, IsFollowedByTheTpdosOfAUnitThatStayedOperational) {
  LostUnit unit;
  unit.passes(100ms);

  unit.device.on_bus_state(BusState::Active, unit.now);
  const Lines lines = unit.passes(Device::kCycle);

  for (const char* const tpdo : {"185#", "285#", "385#", "485#"}) EXPECT_EQ(from(tpdo, lines).size(), 1U) << tpdo;
}

TEST(BusOff, LeavesOperationalAsP8609SaysWithF08701) {
  struct Case {
    std::uint32_t behaviour;
    canopen::NmtState state;
    Numbers faults;
  };
  for (const auto& [behaviour, state, faults] :
       {Case{0, canopen::NmtState::PreOperational, {8700, 8701}}, Case{1, canopen::NmtState::Operational, {8700}},
        Case{2, canopen::NmtState::Stopped, {8700, 8701}}}) {
    ControlUnit unit;
    ASSERT_EQ(unit.download(kErrorBehaviour, 0, behaviour, 2), 0U);
    unit.says("000#0105");

    unit.device.on_bus_state(BusState::Off, unit.now);
    unit.device.on_bus_state(BusState::Active, unit.now);

    EXPECT_EQ(unit.state(), state) << behaviour;
    EXPECT_EQ(unit.faults(2), faults) << behaviour;
  }
}

TEST(BusOff, LetsEachAxisReactAsItsP8641Says) {
  Configuration configuration{.node_id = 5, .axes = {}};
  for (const double reaction : {0.0, 1.0, 2.0, 3.0})
    configuration.axes.push_back({.drive = {}, .presets = {{1120, 0.1}, {1121, 20.0}, {8641, reaction}}});
  TestUnit unit{configuration};
  unit.start_operational();
  for (const std::uint32_t word : {6U, 7U, 15U})
    for (std::uint16_t axis = 0; axis < 4; ++axis) {
      ASSERT_EQ(unit.download(static_cast<std::uint16_t>(0x6040 + 0x800 * axis), 0, word, 2), 0U);
      unit.passes(Device::kCycle);
    }
  for (std::uint16_t axis = 0; axis < 4; ++axis)
    ASSERT_EQ(unit.download(static_cast<std::uint16_t>(0x60FF + 0x800 * axis), 0, 0x06400000, 4), 0U);  // 1500 rpm
  unit.passes(1s);

  unit.device.on_bus_state(BusState::Off, unit.now);
  unit.passes(40ms);

  const auto state = [&](std::uint16_t axis) {
    return unit.upload(static_cast<std::uint16_t>(0x6041 + 0x800 * axis)).number() & 0x4F;
  };
  EXPECT_EQ(state(0) & 0x0F, 0x0FU) << "no reaction: it turns on, with a fault";
  EXPECT_EQ(state(1), 0x0FU) << "OFF1";
  EXPECT_EQ(state(2), 0x08U) << "OFF2";
  EXPECT_EQ(state(3), 0x0FU) << "OFF3";
  unit.passes(2s);
  const auto speed = [&](std::uint16_t axis) {
    return static_cast<std::int32_t>(
        static_cast<std::uint32_t>(unit.upload(static_cast<std::uint16_t>(0x606C + 0x800 * axis)).number()));
  };
  EXPECT_NEAR(speed(0), bus_speed(1500), bus_speed(5));
  EXPECT_GT(speed(1), bus_speed(500)) << "p1121 is 20 s";
  EXPECT_EQ(state(3), 0x08U);
}

TEST(LifeGuarding, IsNotRaisedOverABusOff) {
  ControlUnit unit;
  ASSERT_EQ(unit.download(0x100C, 0, 100, 2), 0U);
  ASSERT_EQ(unit.download(0x100D, 0, 3, 1), 0U);
  unit.says("000#0105");
  unit.says("705#R");

  unit.device.on_bus_state(BusState::Off, unit.now);
  unit.passes(1s);

  EXPECT_EQ(unit.device.axis().messages().faults()[0].value, 1U);
}

TEST(IndicatorLeds, ShowStateAndWorstTrouble) {
  using enum LedPattern;
  ControlUnit unit;
  EXPECT_EQ(unit.device.leds(), (IndicatorLeds{Blinking, Off}));
  unit.says("000#0205");
  EXPECT_EQ(unit.device.leds(), (IndicatorLeds{SingleFlash, Off}));
  unit.says("000#0105");
  EXPECT_EQ(unit.device.leds(), (IndicatorLeds{On, Off}));

  unit.device.on_bus_state(BusState::Passive, unit.now);
  EXPECT_EQ(unit.device.leds(), (IndicatorLeds{On, SingleFlash}));
  ASSERT_TRUE(unit.device.raise(1, 8700, 2, unit.now));
  EXPECT_EQ(unit.device.leds(), (IndicatorLeds{On, DoubleFlash}));
  unit.device.on_bus_state(BusState::Off, unit.now);
  EXPECT_EQ(unit.device.leds(), (IndicatorLeds{On, On}));
}

TEST(IndicatorLeds, AreDarkBeforeTheStart) {
  const TestUnit unit;

  EXPECT_EQ(unit.device.leds(), (IndicatorLeds{LedPattern::Off, LedPattern::Off}));
}

TEST(IndicatorLeds, HaveTheNamesOfCia303) {
  EXPECT_EQ(name_of(LedPattern::Off), "off");
  EXPECT_EQ(name_of(LedPattern::On), "on");
  EXPECT_EQ(name_of(LedPattern::Blinking), "blinking");
  EXPECT_EQ(name_of(LedPattern::SingleFlash), "single flash");
  EXPECT_EQ(name_of(LedPattern::DoubleFlash), "double flash");
}

}  // namespace
}  // namespace device
