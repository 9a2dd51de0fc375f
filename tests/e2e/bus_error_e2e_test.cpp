#include <algorithm>
#include <chrono>
#include <thread>

#include "tests/e2e/bus_sdo_client.hpp"
#include "tests/e2e/candump_log.hpp"
#include "tests/e2e/daemon_process.hpp"

namespace e2e {
namespace {

// Error frames as SocketCAN writes them (linux/can/error.h).
constexpr const char* kBusOff = "20000040#0000000000000000";
constexpr const char* kRestarted = "20000100#0000000000000000";
constexpr const char* kErrorPassive = "20000004#0020000000000000";
constexpr const char* kErrorActive = "20000004#0040000000000000";

// Parameters of the control unit, as its window shows them.
constexpr std::uint16_t kClearBusOff = 0x2000 + 8608, kMonitoringTime = 0x2000 + 8699;
constexpr std::uint16_t kStatusword = 0x6041;
constexpr std::uint32_t kHundred = 0x42C80000;  // as REAL32

const std::string kNothingLeft = "085#0000000000000000";

/// It is soon at speed, and OFF3 takes long enough to be seen on a slow machine.
const nlohmann::json kBriskAxis{{"parameters", {{"p1120", 0.5}, {"p1121", 3.0}, {"p1135", 3.0}}}};

/// A unit whose motor turns, on a bus that candump records.
struct BusError : testing::Test {
  CandumpLog log;
  CanClient can{kTestInterface};
  BusSdoClient sdo;
  DaemonProcess daemon{{.axis = kBriskAxis}};

  void SetUp() override {
    ASSERT_TRUE(daemon.is_ready());
    ASSERT_EQ(sdo.download(0x41B6, 0, 1, 2), 0U);  // the window shows the control unit
    ASSERT_NO_FATAL_FAILURE(make_motor_turn(can));
    ASSERT_TRUE(wait_for_drive(can, "half the speed", [](const StatusAndSpeed& drive) {
      constexpr std::int32_t kHalf = 0x06400000;  // 1500 rpm
      return drive.speed > kHalf;
    }));
    can.listen_to({0x285});
  }
  std::uint16_t statusword() { return static_cast<std::uint16_t>(sdo.upload(kStatusword).number()); }
  /// 6041h as the control socket shows it, in every NMT state.
  std::uint16_t shown_statusword() const {
    const auto word = daemon.status().at("axes").at(0).at("statusword").get<std::string>();
    return static_cast<std::uint16_t>(std::stoul(word, nullptr, 16));
  }
  /// The control socket shows @p wanted before long.
  testing::AssertionResult comes_to(const DriveState& wanted) const {
    const auto end = std::chrono::steady_clock::now() + kPatience;
    while (std::chrono::steady_clock::now() < end)
      if ((shown_statusword() & wanted.mask) == wanted.value) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "never " << wanted.name;
  }
  /// p1135. Who asks for the state while it brakes lets it take so long that it cannot be over when he asks.
  void set_off3_time(const char* seconds) const {
    ASSERT_EQ(daemon.axisctl({"set", "1/p1135", seconds}).status, 0);
  }
  std::string led(const char* which) const { return daemon.status().at("leds").at(which).get<std::string>(); }
  /// OFF3 to standstill as the statuswords of TPDO 2 show it, and Fault at its end.
  testing::AssertionResult brakes_into_fault() {
    if (auto seen = wait_for_state(can, kFaultReactionActive); !seen) return seen;
    return wait_for_drive(can, "Fault at standstill",
                          [](const StatusAndSpeed& drive) { return drive.is(kFault) && drive.has(kStandstill); });
  }
};

TEST_F(BusError, BusOffStopsTheMotorInSilenceUntilP8608EndsIt) {
  ASSERT_TRUE(log.send(kBusOff));
  ASSERT_TRUE(daemon.program().wait_for_output("bus-off"));
  EXPECT_EQ(sdo.upload(0x1000).number(), 0xFFFF0192U);
  ASSERT_TRUE(log.shows({"605#4000100000000000", "585#430010009201FFFF"}));

  EXPECT_TRUE(sdo.comes_to(kStatusword, kFault));
  EXPECT_TRUE(log.shows_none_of({"085", "185", "285", "385", "485"}));
  EXPECT_EQ(led("error"), "on");

  EXPECT_EQ(sdo.download(kClearBusOff, 0, 1, 2), 0U);
  EXPECT_TRUE(
      log.shows({"605#2BA0410001000000", "585#60A0410000000000", "085#011011FC21010000", "085#011011FC21020000"}));
  EXPECT_TRUE(wait_for_state(can, kFault)) << "the TPDOs are back";
  EXPECT_EQ(sdo.upload(kClearBusOff, 0).number(), 0U);
  EXPECT_EQ(led("error"), "off");

  EXPECT_EQ(sdo.download(0x1003, 0, 0, 1), 0U);
  EXPECT_TRUE(log.shows({kNothingLeft, "585#6003100000000000"}));
  EXPECT_TRUE(wait_for_state(can, kSwitchOnDisabled));
}

TEST_F(BusError, BusOffEndsWithTheRestartOfTheController) {
  ASSERT_TRUE(log.send(kBusOff));
  ASSERT_TRUE(daemon.program().wait_for_output("bus-off"));

  ASSERT_TRUE(log.send(kRestarted));

  EXPECT_TRUE(log.shows({"085#011011FC21010000", "085#011011FC21020000"}));
}

TEST_F(BusError, BusOffEndsByItselfIfP8608SaysSo) {
  ASSERT_EQ(sdo.download(kClearBusOff, 1, 1, 2), 0U);

  ASSERT_TRUE(log.send(kBusOff));

  EXPECT_TRUE(log.shows({"085#011011FC21010000", "085#011011FC21020000"}));
  EXPECT_TRUE(daemon.program().wait_for_output("restart from bus-off"));
}

TEST_F(BusError, BusOffIsEndedOverTheControlSocketAndCanComeAgain) {
  EXPECT_EQ(daemon.axisctl({"bus", "restart"}).status, 3) << "the bus is not off";
  for (int i = 0; i < 2; ++i) {
    const std::size_t from = daemon.program().output().size();
    ASSERT_TRUE(log.send(kBusOff));
    ASSERT_TRUE(daemon.program().wait_for_output("bus-off", from));
    EXPECT_EQ(daemon.axisctl({"bus", "restart"}).status, 0);
    EXPECT_TRUE(log.shows({"085#011011FC21010000", "085#011011FC21020000"}));
    EXPECT_TRUE(sdo.comes_to(kStatusword, kFault));
    ASSERT_EQ(sdo.download(0x1003, 0, 0, 1), 0U);
  }
}

TEST_F(BusError, ErrorPassiveIsAnAlarm) {
  ASSERT_TRUE(log.send(kErrorPassive));
  EXPECT_TRUE(log.shows({"085#2081113022010000"}));
  EXPECT_EQ(led("error"), "single flash");

  ASSERT_TRUE(log.send(kErrorActive));
  EXPECT_TRUE(log.shows({kNothingLeft}));
  EXPECT_EQ(statusword() & 0x0F, 0x07) << "no reaction";
}

TEST_F(BusError, LossOfLifeGuardingStopsTheMotor) {
  ASSERT_EQ(sdo.download(0x100C, 0, 100, 2), 0U);
  ASSERT_EQ(sdo.download(0x100D, 0, 3, 1), 0U);
  ASSERT_TRUE(log.send("705#R"));
  ASSERT_TRUE(log.shows({"705#05"}));

  EXPECT_TRUE(log.shows({"085#308111FC21010000", "085#308111FC21020000"}));
  EXPECT_TRUE(brakes_into_fault());
  EXPECT_EQ(led("error"), "double flash");
}

TEST_F(BusError, NmtStopInMotionBringsTheMotorToStandstill) {
  set_off3_time("600");
  ASSERT_TRUE(log.send("000#0205"));
  ASSERT_TRUE(comes_to(kFaultReactionActive));
  ASSERT_TRUE(log.send("7FF#01"));  // behind TPDOs that were under way

  set_off3_time("0.5");
  ASSERT_TRUE(comes_to(kFault));
  EXPECT_NE(shown_statusword() & kStandstill, 0);
  EXPECT_TRUE(log.shows_none_of({"085", "185", "285"})) << "a stopped node says nothing";

  EXPECT_TRUE(log.send("000#8005"));
  EXPECT_TRUE(log.send("605#4003100300000000"));
  EXPECT_TRUE(log.shows({"585#430310030110FD21"}));
}

TEST_F(BusError, LeavingOperationalInMotionIsTold) {
  set_off3_time("600");
  ASSERT_TRUE(log.send("000#8005"));

  EXPECT_TRUE(log.shows({"085#011011FD21020000"}));
  EXPECT_TRUE(sdo.comes_to(kStatusword, kFaultReactionActive));
  set_off3_time("0.5");
  EXPECT_TRUE(sdo.comes_to(kStatusword, kFault));
}

TEST_F(BusError, MissingProcessDataStopTheMotor) {
  ASSERT_EQ(sdo.download(kMonitoringTime, 0, kHundred, 4), 0U);
  ASSERT_TRUE(log.send("205#0F00"));

  EXPECT_TRUE(log.shows({"085#011011FE21010000", "085#011011FE21020000"}));
  EXPECT_TRUE(brakes_into_fault());
}

/// A unit at rest whose first RPDO of a burst wakes it: the others come before its cycle ends.
TEST(LostTelegrams, AreAnAlarmThatEnds) {
  CandumpLog log;
  CanClient can{kTestInterface};
  DaemonProcess daemon;
  ASSERT_TRUE(daemon.is_ready());
  ASSERT_TRUE(can.ask("000#0105", "185#4016"));
  can.listen_to({});
  constexpr int kMostBursts = 20;
  constexpr int kBurst = 10;
  for (int i = 0; i < kMostBursts && daemon.bus_counter("lost_telegrams") == 0; ++i)
    for (int k = 0; k < kBurst; ++k) can.send("205#0600");

  EXPECT_GT(daemon.bus_counter("lost_telegrams"), 0U);
  EXPECT_TRUE(log.shows({"085#1081112F22010000", "185#B116"}));
  EXPECT_TRUE(log.shows({kNothingLeft, "185#3116"}));
}

}  // namespace
}  // namespace e2e
