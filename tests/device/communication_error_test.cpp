#include <array>

#include "tests/device/communication_fixture.hpp"

namespace device {
namespace {

/// A unit of two axes that the master has stopped guarding, in Operational.
struct Guarded : ControlUnit {
  explicit Guarded(std::uint8_t behaviour) : ControlUnit{2} {
    EXPECT_EQ(download(0x1029, 1, behaviour, 1), 0U);
    EXPECT_EQ(download(0x100C, 0, 100, 2), 0U);
    EXPECT_EQ(download(0x100D, 0, 3, 1), 0U);
    says("000#0105");
    says("705#R");
  }
};

TEST(LifeGuarding, RaisesF08700OnEveryDriveObject) {
  Guarded unit{1};

  EXPECT_EQ(from("085#", unit.passes(400ms)),
            (Lines{"085#308111FC21010000", "085#308111FC21020000", "085#308111FC21030000"}));

  for (const std::uint8_t object : std::vector<std::uint8_t>{1, 2, 3})
    EXPECT_EQ(unit.faults(object), Numbers{8700}) << int{object};
  EXPECT_EQ(unit.device.axis().messages().faults()[0].value, 2U);
  EXPECT_EQ(unit.state(), canopen::NmtState::Operational);
}

TEST(LifeGuarding, ChangesTheNmtStateAs1029hSays) {
  Guarded leaving{0}, stopping{2};

  leaving.passes(400ms);
  stopping.passes(400ms);

  EXPECT_EQ(leaving.state(), canopen::NmtState::PreOperational);
  EXPECT_EQ(leaving.faults(2), (Numbers{8700, 8701}));
  EXPECT_EQ(stopping.state(), canopen::NmtState::Stopped);
}

TEST(LifeGuarding, LetsTheAxisReactAsP8641Says) {
  for (const std::uint32_t reaction : {0U, 3U}) {
    TestUnit unit{unit_with({{1120, 0.1}, {8641, static_cast<double>(reaction)}})};
    unit.turn_at(1000, 500ms);
    ASSERT_EQ(unit.download(0x100C, 0, 100, 2), 0U);
    ASSERT_EQ(unit.download(0x100D, 0, 3, 1), 0U);
    unit.says("705#R");

    unit.passes(3s);

    EXPECT_NEAR(unit.velocity(), reaction == 0 ? bus_speed(1000) : 0.0, bus_speed(5));
    EXPECT_EQ(unit.statusword() & 0x08, 0x08);
  }
}

TEST(DeviceFault, ChangesTheNmtStateAsTheSecondClassSays) {
  struct Case {
    std::uint32_t behaviour;
    canopen::NmtState state;
  };
  for (const auto& [behaviour, state] :
       {Case{0, canopen::NmtState::PreOperational}, Case{1, canopen::NmtState::Operational},
        Case{2, canopen::NmtState::Stopped}}) {
    ControlUnit unit;
    ASSERT_EQ(unit.download(0x1029, 2, behaviour, 1), 0U);
    ASSERT_EQ(unit.upload(0x2000 + 8609, 1).number(), behaviour);
    unit.says("000#0105");

    ASSERT_TRUE(unit.device.raise(1, 7900, 0, unit.now));

    EXPECT_EQ(unit.state(), state);
    EXPECT_EQ(unit.faults(2), behaviour == 1 ? Numbers{7900} : (Numbers{7900, 8701}));
  }
}

TEST(DeviceFault, SendsItsEmcyBeforeTheNodeStops) {
  ControlUnit unit;
  ASSERT_EQ(unit.download(0x1029, 2, 2, 1), 0U);
  unit.says("000#0105");

  ASSERT_TRUE(unit.device.raise(1, 7900, 0, unit.now));

  EXPECT_EQ(from("085#", unit.passes(0ms)), Lines{"085#001081DC1E020000"});
}

TEST(BusState, ErrorPassiveIsAnAlarmAsLongAsItLasts) {
  ControlUnit unit;

  unit.device.on_bus_state(BusState::Passive, unit.now);
  EXPECT_EQ(unit.passes(0ms), Lines{"085#2081113022010000"});
  EXPECT_EQ(unit.upload(0x1003, 0).number(), 1U);

  unit.device.on_bus_state(BusState::Active, unit.now);
  EXPECT_EQ(from("085#", unit.passes(0ms)), Lines{"085#0000000000000000"});
  EXPECT_EQ(unit.upload(0x1003, 0).number(), 0U);
}

TEST(BusState, BusOffStopsTheAxesAndIsToldOnceTheBusIsBack) {
  ControlUnit unit{2};
  unit.says("000#0105");

  unit.device.on_bus_state(BusState::Off, unit.now);
  EXPECT_EQ(from("085#", unit.passes(100ms)), Lines{});
  EXPECT_EQ(unit.faults(3), Numbers{8700});
  EXPECT_EQ(unit.device.axis().messages().faults()[0].value, 1U);
  EXPECT_FALSE(unit.device.acknowledge(1, unit.now)) << "the cause is there";

  unit.device.on_bus_state(BusState::Active, unit.now);
  EXPECT_EQ(from("085#", unit.passes(0ms)),
            (Lines{"085#011011FC21010000", "085#011011FC21020000", "085#011011FC21030000"}));
  EXPECT_EQ(unit.state(), canopen::NmtState::Operational);
  EXPECT_EQ(unit.download(0x1003, 0, 0, 1), 0U);
  EXPECT_EQ(unit.faults(3), Numbers{});
}

TEST(BusState, BusOffChangesTheNmtStateAs1029hSays) {
  ControlUnit unit;
  ASSERT_EQ(unit.download(0x1029, 1, 0, 1), 0U);
  unit.says("000#0105");

  unit.device.on_bus_state(BusState::Off, unit.now);
  unit.device.on_bus_state(BusState::Active, unit.now);

  EXPECT_EQ(unit.state(), canopen::NmtState::PreOperational);
  EXPECT_EQ(unit.faults(2), (Numbers{8700, 8701}));
}

TEST(BusState, AnInterfaceThatComesUpAgainEndsBusOff) {
  ControlUnit unit;
  unit.device.on_bus_state(BusState::Off, unit.now);

  EXPECT_EQ(unit.start(), (Lines{"705#00", "085#011011FC21010000", "085#011011FC21020000"}));

  EXPECT_EQ(unit.download(0x1003, 0, 0, 1), 0U);
  EXPECT_EQ(unit.faults(2), Numbers{});
}

TEST(BusOffParameter, TakesTheCommandsAndShowsTheAutomaticRestart) {
  ControlUnit unit;
  const std::uint16_t index = 0x2000 + 8608;

  EXPECT_EQ(unit.download(index, 0, 1, 2), 0U);
  EXPECT_EQ(unit.upload(index, 0).number(), 0U);
  EXPECT_EQ(unit.download(index, 1, 1, 2), 0U);
  EXPECT_EQ(unit.upload(index, 1).number(), 1U);
}

TEST(RpdoMonitoring, RaisesF08702WhenNoRpdoComesAnyMore) {
  ControlUnit unit{2};
  ASSERT_EQ(unit.download(0x2000 + 8699, 0, 0x42C80000, 4), 0U);  // 100 ms
  unit.says("000#0105");
  EXPECT_EQ(from("085#", unit.passes(1s)), Lines{}) << "no RPDO has come yet";

  for (int i = 0; i < 5; ++i) {
    unit.says("205#0600");
    EXPECT_EQ(from("085#", unit.passes(99ms)), Lines{});
  }
  EXPECT_EQ(from("085#", unit.passes(2ms)),
            (Lines{"085#011011FE21010000", "085#011011FE21020000", "085#011011FE21030000"}));
  EXPECT_EQ(unit.faults(3), Numbers{8702});
  EXPECT_EQ(unit.download(0x1003, 0, 0, 1), 0U);
  EXPECT_EQ(from("085#", unit.passes(1s)), Lines{});
}

TEST(RpdoMonitoring, IsJudgedWhereACycleEnds) {
  ControlUnit unit;
  ASSERT_EQ(unit.download(0x2000 + 8699, 0, 0x40A00000, 4), 0U);  // 5 ms are two cycles
  unit.says("000#0105");
  unit.passes(101ms);

  unit.says("205#0600");
  EXPECT_EQ(from("085#", unit.passes(10ms)), Lines{});
  EXPECT_EQ(from("085#", unit.passes(1ms)).size(), 2U) << "112 ms after the start";
}

TEST(RpdoMonitoring, MissesNothingThatALateUnitReadsFirst) {
  ControlUnit unit;
  ASSERT_EQ(unit.download(0x2000 + 8699, 0, 0x42C80000, 4), 0U);  // 100 ms
  unit.says("000#0105");
  unit.says("205#0600");

  unit.now += 10s;
  unit.device.on_frame(fakes::frame_of("205#0600"), unit.now);
  unit.device.on_time(unit.now);

  EXPECT_EQ(from("085#", unit.passes(99ms)), Lines{});
}

TEST(RpdoMonitoring, EndsWithOperationalAndWithTheTime0) {
  ControlUnit unit;
  ASSERT_EQ(unit.download(0x2000 + 8699, 0, 0x42C80000, 4), 0U);
  unit.says("000#0105");
  unit.says("205#0600");
  ASSERT_EQ(unit.download(0x2000 + 8699, 0, 0, 4), 0U);
  unit.passes(1s);
  EXPECT_EQ(unit.faults(2), Numbers{});

  ASSERT_EQ(unit.download(0x2000 + 8699, 0, 0x42C80000, 4), 0U);
  unit.says("205#0600");
  unit.says("000#8005");
  unit.passes(1s);
  EXPECT_EQ(unit.faults(2), Numbers{8701});
}

}  // namespace
}  // namespace device
