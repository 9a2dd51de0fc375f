#include <array>

#include "tests/device/test_unit.hpp"

namespace device {
namespace {

constexpr std::uint32_t kInvalidValue = 0x06090030, kDeviceState = 0x08000022, kReadOnly = 0x06010002;
constexpr std::uint32_t kTooHigh = 0x06090031;
constexpr std::uint16_t kStartState = 0x2000 + 8684, kNmtState = 0x2000 + 8685;

/// A unit whose window shows the control unit.
struct ControlUnit : TestUnit {
  explicit ControlUnit(std::size_t axes = 1) : TestUnit{{.node_id = 5, .axes = std::vector<AxisSetup>(axes)}} {
    start();
    open(1);
  }
  void open(std::uint16_t object) { ASSERT_EQ(download(0x41B6, 0, object, 2), 0U); }
  canopen::NmtState state() const { return device.node().state(); }
  std::vector<std::uint16_t> faults(std::uint8_t object) const {
    std::vector<std::uint16_t> numbers;
    for (const drive::FaultEntry& entry : device.unit().object(object)->messages().faults())
      numbers.push_back(entry.row->number);
    return numbers;
  }
};

using Numbers = std::vector<std::uint16_t>;

TEST(StartState, IsEnteredWithTheNextReset) {
  ControlUnit unit;
  ASSERT_EQ(unit.download(kStartState, 0, 5, 2), 0U);
  EXPECT_EQ(unit.state(), canopen::NmtState::PreOperational);

  unit.says("000#8205");

  EXPECT_EQ(unit.state(), canopen::NmtState::Operational);
}

TEST(StartState, MayBeStopped) {
  ControlUnit unit;
  ASSERT_EQ(unit.download(kStartState, 0, 4, 2), 0U);

  EXPECT_EQ(unit.says("000#8205"), Lines{"705#00"});

  EXPECT_EQ(unit.state(), canopen::NmtState::Stopped);
}

TEST(StartState, RefusesOtherValues) {
  ControlUnit unit;

  for (const std::uint32_t value : {6U, 126U}) EXPECT_EQ(unit.download(kStartState, 0, value, 2), kInvalidValue);
  EXPECT_EQ(unit.download(kStartState, 0, 128, 2), kTooHigh);
  EXPECT_EQ(unit.upload(kStartState).number(), 127U);
}

TEST(NmtStateParameter, ShowsTheState) {
  ControlUnit unit;

  EXPECT_EQ(unit.upload(kNmtState).number(), 127U);
  unit.says("000#0105");
  EXPECT_EQ(unit.upload(kNmtState).number(), 5U);
}

TEST(NmtStateParameter, ChangesTheStateAfterTheAnswer) {
  ControlUnit unit;

  EXPECT_EQ(unit.says("605#2BED410005000000").at(0), "585#60ED410000000000");
  EXPECT_EQ(unit.state(), canopen::NmtState::Operational);
  EXPECT_EQ(unit.says("605#2BED41007F000000"), (Lines{"585#60ED410000000000", "085#011011FD21020000"}));
  EXPECT_EQ(unit.state(), canopen::NmtState::PreOperational);
  EXPECT_EQ(unit.faults(2), Numbers{8701});
  EXPECT_EQ(unit.says("605#2BED410004000000"), Lines{"585#60ED410000000000"});
  EXPECT_EQ(unit.state(), canopen::NmtState::Stopped);
}

TEST(NmtStateParameter, Resets) {
  for (const char* const value : {"8000", "8100"}) {
    ControlUnit unit;
    EXPECT_EQ(unit.says(std::string{"605#2BED4100"} + value + "0000"), (Lines{"585#60ED410000000000", "705#00"}));
    EXPECT_EQ(unit.state(), canopen::NmtState::PreOperational);
  }
}

TEST(NmtStateParameter, RefusesOtherValues) {
  ControlUnit unit;

  for (const std::uint32_t value : {0U, 1U, 3U, 126U})
    EXPECT_EQ(unit.download(kNmtState, 0, value, 2), kInvalidValue) << value;
  EXPECT_EQ(unit.download(kNmtState, 0, 130, 2), kTooHigh);
  EXPECT_EQ(unit.state(), canopen::NmtState::PreOperational);
}

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

TEST(NodeAddress, BelongsToTheConfiguration) {
  ControlUnit unit;

  EXPECT_EQ(unit.upload(0x2000 + 8620).number(), 5U);
  EXPECT_EQ(unit.upload(0x2000 + 8621).number(), 5U);
  EXPECT_EQ(unit.download(0x2000 + 8620, 0, 6, 1), kDeviceState);
  EXPECT_EQ(unit.download(0x2000 + 8621, 0, 6, 1), kReadOnly);
  EXPECT_EQ(unit.download(0x2000 + 8622, 0, 2, 2), 0U);
  EXPECT_EQ(unit.upload(0x2000 + 8622).number(), 2U);
}

TEST(ErrorControl, RefusesTheOtherMechanismByObjectAndByParameter) {
  ControlUnit unit;
  ASSERT_EQ(unit.download(0x2000 + 8606, 0, 100, 2), 0U);

  EXPECT_EQ(unit.upload(0x1017).number(), 100U);
  for (std::uint8_t index = 0; index < 2; ++index)
    EXPECT_EQ(unit.download(0x2000 + 8604, index, 1, 2), kDeviceState);
  EXPECT_EQ(unit.download(0x100C, 0, 1, 2), kDeviceState);
  EXPECT_EQ(unit.download(0x100D, 0, 1, 1), kDeviceState);
  ASSERT_EQ(unit.download(0x1017, 0, 0, 2), 0U);
  EXPECT_EQ(unit.download(0x2000 + 8604, 0, 100, 2), 0U);
  EXPECT_EQ(unit.download(0x2000 + 8604, 1, 256, 2), kTooHigh) << "100Dh has one byte";
  EXPECT_EQ(unit.download(0x2000 + 8604, 1, 3, 2), 0U);
  EXPECT_EQ(unit.download(0x2000 + 8606, 0, 100, 2), kDeviceState);
  EXPECT_EQ(unit.download(0x1017, 0, 100, 2), kDeviceState);
}

TEST(Emcy, IsSuppressedByBit31) {
  ControlUnit unit;
  ASSERT_EQ(unit.download(0x1014, 0, 0x80000085, 4), 0U);

  ASSERT_TRUE(unit.device.raise(1, 7900, 0, unit.now));
  EXPECT_EQ(from("085#", unit.passes(100ms)), Lines{});
  EXPECT_EQ(unit.upload(0x1003, 0).number(), 1U);

  ASSERT_EQ(unit.download(0x1014, 0, 0x85, 4), 0U);
  ASSERT_TRUE(unit.device.raise(1, 7901, 0, unit.now));
  EXPECT_EQ(from("085#", unit.passes(0ms)), Lines{"085#001081DD1E020000"});
}

TEST(Emcy, AndSyncIdentifiersKeepTheRulesOfCia301) {
  ControlUnit unit;

  EXPECT_EQ(unit.download(0x1014, 0, 0x00000086, 4), kDeviceState);
  EXPECT_EQ(unit.download(0x2000 + 8603, 0, 0, 4), kInvalidValue);
  EXPECT_EQ(unit.download(0x1005, 0, 0x40000080, 4), kInvalidValue);
  EXPECT_EQ(unit.download(0x2000 + 8602, 0, 0x40000080, 4), kInvalidValue);
  EXPECT_EQ(unit.download(0x2000 + 8602, 0, 0x90, 4), 0U);
  EXPECT_EQ(unit.upload(0x1005).number(), 0x90U);
}

}  // namespace
}  // namespace device
