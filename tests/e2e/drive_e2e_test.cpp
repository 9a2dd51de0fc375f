// Dialogues that move axes, as a person at a terminal has them with cansend and candump.
#include <chrono>
#include <cmath>
#include <cstdint>
#include <string>
#include <thread>
#include <utility>

#include "tests/e2e/bus_sdo_client.hpp"
#include "tests/e2e/candump_log.hpp"
#include "tests/e2e/daemon_process.hpp"

namespace e2e {
namespace {

constexpr std::int32_t kFullSpeed = 0x0C800000;  // 3000 rpm

/// Short ramps, and friction enough for the motor to coast to rest soon.
const nlohmann::json kBriskAxis{{"load", {{"friction", {{"coulomb", 2.0}}}}},
                                {"parameters", {{"p1120", 1.0}, {"p1121", 1.5}, {"p1135", 0.7}}}};

bool is_near(std::int32_t speed, std::int32_t wanted) {
  return std::abs(speed - wanted) <= kFullSpeed / 500;
}

struct DriveDialogue : testing::Test {
  CandumpLog log;
  CanClient can{kTestInterface};
  BusSdoClient sdo;
  DaemonProcess daemon;

  explicit DriveDialogue(int axes = 1, const nlohmann::json& axis = kBriskAxis)
      : daemon{{.axis = axis, .axes = axes}} {}

  void SetUp() override { ASSERT_TRUE(daemon.is_ready()); }
  /// The steps from power-on to Operation enabled, one frame and one answer each.
  void switch_on() {
    struct Step {
      const char* sent;
      const char* answer;
    };
    for (const Step& step : {Step{"000#0105", "185#4016"}, Step{"205#0600", "185#3116"},
                             Step{"205#0700", "185#3316"}, Step{"205#0F00", "185#3716"}}) {
      ASSERT_TRUE(log.send(step.sent));
      ASSERT_TRUE(log.shows({step.answer})) << step.sent;
    }
  }
  void run_at_full_speed() {
    ASSERT_NO_FATAL_FAILURE(switch_on());
    can.listen_to({0x285});
    ASSERT_TRUE(log.send("305#0F000000800C"));
    ASSERT_TRUE(reaches("3000 rpm and target reached", kOperationEnabled, kFullSpeed));
    ASSERT_TRUE(log.shows({"185#3706"})) << "in motion the target is not reached and the speed not zero"
                                         << " before it is";
  }
  testing::AssertionResult reaches(const std::string& what, const DriveState& state, std::int32_t speed) {
    return wait_for_drive(can, what, [&](const StatusAndSpeed& drive) {
      return drive.is(state) && is_near(drive.speed, speed) && drive.has(kTargetReached);
    });
  }
  testing::AssertionResult stands_in(const DriveState& state) {
    return wait_for_drive(can, std::string{state.name} + " at standstill",
                          [&](const StatusAndSpeed& drive) { return drive.is(state) && drive.has(kStandstill); });
  }
  testing::AssertionResult turns_in(const DriveState& state) {
    return wait_for_drive(can, std::string{state.name} + " while turning",
                          [&](const StatusAndSpeed& drive) { return drive.is(state) && !drive.has(kStandstill); });
  }
  void write(std::uint16_t index, std::uint8_t sub, std::uint32_t value, unsigned bytes) {
    ASSERT_EQ(sdo.download(index, sub, value, bytes), 0U) << std::hex << index << ':' << unsigned{sub};
  }
};

TEST_F(DriveDialogue, StartsAndFollowsTheRamp) {
  ASSERT_NO_FATAL_FAILURE(switch_on());
  can.listen_to({0x285});

  ASSERT_TRUE(log.send("305#0F000000800C"));

  std::int32_t before = 0;
  bool rises = true;
  EXPECT_TRUE(wait_for_drive(can, "3000 rpm", [&](const StatusAndSpeed& drive) {
    rises = rises && drive.speed >= before - kFullSpeed / 200;
    before = drive.speed;
    return is_near(drive.speed, kFullSpeed) && drive.has(kTargetReached);
  }));
  EXPECT_TRUE(rises);
}

TEST_F(DriveDialogue, Off1BrakesAndLeavesItReadyToSwitchOn) {
  ASSERT_NO_FATAL_FAILURE(run_at_full_speed());
  ASSERT_TRUE(log.send("205#0600"));
  EXPECT_TRUE(turns_in(kOperationEnabled));
  EXPECT_TRUE(stands_in(kReadyToSwitchOn));
  EXPECT_TRUE(log.shows({"185#3116"}));
}

TEST_F(DriveDialogue, Off2LetsItCoastAndInhibitsSwitchingOn) {
  ASSERT_NO_FATAL_FAILURE(run_at_full_speed());
  ASSERT_TRUE(log.send("205#0D00"));
  EXPECT_TRUE(turns_in(kSwitchOnDisabled));
  EXPECT_TRUE(stands_in(kSwitchOnDisabled));
  ASSERT_TRUE(log.send("205#0F00"));
  EXPECT_TRUE(log.shows({"185#7016"})) << "ON needs an edge";
}

TEST_F(DriveDialogue, QuickStopBrakesFasterAndInhibitsSwitchingOn) {
  ASSERT_NO_FATAL_FAILURE(run_at_full_speed());
  ASSERT_TRUE(log.send("205#0B00"));
  EXPECT_TRUE(turns_in(kQuickStopActive));
  EXPECT_TRUE(stands_in(kSwitchOnDisabled));
  ASSERT_TRUE(log.send("205#0600"));
  EXPECT_TRUE(log.shows({"185#3116"}));
}

TEST_F(DriveDialogue, HaltStopsItWithThePulsesOnAndLetsItGoOn) {
  ASSERT_NO_FATAL_FAILURE(run_at_full_speed());
  ASSERT_NO_FATAL_FAILURE(write(0x605D, 0, 1, 2));
  ASSERT_TRUE(log.send("205#0F01"));
  EXPECT_TRUE(stands_in(kOperationEnabled));
  ASSERT_TRUE(log.send("205#0F00"));
  EXPECT_TRUE(reaches("3000 rpm again", kOperationEnabled, kFullSpeed));
}

TEST_F(DriveDialogue, AFaultStopsItUntilItIsAcknowledgedAndOnComesAnew) {
  ASSERT_NO_FATAL_FAILURE(run_at_full_speed());
  ASSERT_EQ(daemon.axisctl({"fault", "inject", "1", "7860"}).status, 0);
  EXPECT_TRUE(log.shows({"085#001081B41E020000"}));
  EXPECT_TRUE(stands_in(kFault));

  ASSERT_TRUE(log.send("205#8F00"));
  EXPECT_TRUE(log.shows({"085#0000000000000000"}));
  EXPECT_TRUE(stands_in(kSwitchOnDisabled)) << "ON is still set";
  for (const auto& [word, state] : {std::pair{"205#0600", kReadyToSwitchOn}, std::pair{"205#0700", kSwitchedOn},
                                    std::pair{"205#0F00", kOperationEnabled}}) {
    ASSERT_TRUE(log.send(word));
    EXPECT_TRUE(wait_for_state(can, state)) << word;
  }
}

/// 6060h in RPDO 5 (312h) and 6061h in TPDO 5 (192h). By its rated torque the motor comes to 4000 rpm, where the
/// friction takes it all, and not to an overspeed, however long it is left alone.
struct ModeDialogue : DriveDialogue {
  ModeDialogue() : DriveDialogue{1, axis()} {}
  static nlohmann::json axis() {
    nlohmann::json axis = kBriskAxis;
    axis["load"]["friction"]["viscous"] = 0.0127;
    return axis;
  }
  void SetUp() override {
    DriveDialogue::SetUp();
    ASSERT_NO_FATAL_FAILURE(write(0x1604, 1, 0x60600008, 4));
    ASSERT_NO_FATAL_FAILURE(write(0x1404, 1, 0x312, 4));
    ASSERT_NO_FATAL_FAILURE(write(0x1A04, 1, 0x60610008, 4));
    ASSERT_NO_FATAL_FAILURE(write(0x1804, 1, 0x40000192, 4));
    ASSERT_NO_FATAL_FAILURE(switch_on());
  }
};

TEST_F(ModeDialogue, TheModeChangesInMotion) {
  ASSERT_TRUE(log.send("312#03"));
  can.listen_to({0x285});
  ASSERT_TRUE(log.send("305#0F0000004006"));
  ASSERT_TRUE(reaches("1500 rpm", kOperationEnabled, kFullSpeed / 2));

  ASSERT_TRUE(log.send("405#0F00E803"));  // more torque than the friction takes
  ASSERT_TRUE(log.send("312#04"));
  EXPECT_TRUE(log.shows({"192#04"}));
  EXPECT_TRUE(wait_for_drive(can, "faster than its speed setpoint", [](const StatusAndSpeed& drive) {
    return drive.is(kOperationEnabled) && drive.speed > kFullSpeed / 2 + kFullSpeed / 20;
  }));

  ASSERT_TRUE(log.send("312#03"));
  EXPECT_TRUE(log.shows({"192#03"}));
  EXPECT_TRUE(reaches("1500 rpm again", kOperationEnabled, kFullSpeed / 2));

  ASSERT_NO_FATAL_FAILURE(write(0x6042, 0, 600, 2));
  ASSERT_TRUE(log.send("312#02"));
  EXPECT_TRUE(log.shows({"192#02"}));
  EXPECT_TRUE(wait_for_drive(can, "standstill: bits 4 to 6 are missing",
                             [](const StatusAndSpeed& drive) { return drive.has(kStandstill); }));
  ASSERT_TRUE(log.send("205#7F00"));
  EXPECT_TRUE(reaches("600 rpm", kOperationEnabled, kFullSpeed / 5));
}

struct TwoAxes : DriveDialogue {
  TwoAxes() : DriveDialogue{2} {}

  std::uint16_t statusword(std::uint16_t index) { return static_cast<std::uint16_t>(sdo.upload(index).number()); }
};

TEST_F(TwoAxes, ReactToOneFaultEachInItsOwnWay) {
  ASSERT_NO_FATAL_FAILURE(write(0x6807, 0, 2, 2));  // OFF2; axis 1 has OFF3
  ASSERT_NO_FATAL_FAILURE(switch_on());
  for (const std::uint32_t word : {0x0006U, 0x0007U, 0x000FU}) ASSERT_NO_FATAL_FAILURE(write(0x6840, 0, word, 2));
  ASSERT_TRUE(sdo.comes_to(0x6841, kOperationEnabled));
  ASSERT_NO_FATAL_FAILURE(write(0x68FF, 0, kFullSpeed / 4, 4));
  can.listen_to({0x285});
  ASSERT_TRUE(log.send("305#0F000000800C"));
  ASSERT_TRUE(reaches("3000 rpm", kOperationEnabled, kFullSpeed));
  ASSERT_NO_FATAL_FAILURE(write(0x100C, 0, 100, 2));
  ASSERT_NO_FATAL_FAILURE(write(0x100D, 0, 3, 1));

  ASSERT_TRUE(log.send("705#R"));
  ASSERT_TRUE(log.shows({"705#05"}));

  EXPECT_TRUE(log.shows({"085#308111FC21010000", "085#308111FC21020000", "085#308111FC21030000"}));
  EXPECT_TRUE(wait_for_state(can, kFaultReactionActive));
  EXPECT_EQ(statusword(0x6841) & kFault.mask, kFault.value) << "its pulses are off at once";
  EXPECT_TRUE(stands_in(kFault));
}

}  // namespace
}  // namespace e2e
