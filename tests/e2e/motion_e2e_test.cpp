#include <cmath>
#include <cstdlib>

#include "tests/e2e/daemon_process.hpp"

namespace e2e {
namespace {

constexpr std::int32_t kFullSpeed = 0x0C800000;  // 3000 rpm
constexpr const char* kRunAtFullSpeed = "305#0F000000800C";

/// Short ramps, and friction enough for the motor to coast to rest soon.
const nlohmann::json kBriskAxis{{"load", {{"friction", {{"coulomb", 2.0}}}}},
                                {"parameters", {{"p1120", 1.0}, {"p1121", 1.0}, {"p1135", 0.5}}}};

struct Motion : RunningDaemon {
  static void SetUpTestSuite() { start({.axis = kBriskAxis}); }

  void SetUp() override {
    RunningDaemon::SetUp();
    // The shaft may still turn from the test before.
    ASSERT_TRUE(can->ask("205#0600", "185#3116") || wait_for_state(*can, kReadyToSwitchOn));
    can->send("205#0700");
    ASSERT_TRUE(wait_for_state(*can, kSwitchedOn));
  }
  /// Brings the motor to 3000 rpm.
  static testing::AssertionResult run() {
    can->send("205#0F00");
    if (const auto enabled = wait_for_state(*can, kOperationEnabled); !enabled) return enabled;
    can->send(kRunAtFullSpeed);
    return wait_for_drive(*can, "3000 rpm within 0.1 % and target reached", [](const StatusAndSpeed& drive) {
      return std::abs(drive.speed - kFullSpeed) <= kFullSpeed / 1000 && drive.has(kTargetReached);
    });
  }
};

TEST_F(Motion, RunsAtTheSpeedAskedFor) {
  EXPECT_TRUE(run());
}

TEST_F(Motion, Off1RampsDownBeforeThePulsesGo) {
  ASSERT_TRUE(run());

  can->send("205#0600");

  EXPECT_TRUE(wait_for_drive(*can, "Operation enabled and half the speed", [](const StatusAndSpeed& drive) {
    return drive.is(kOperationEnabled) && drive.speed < kFullSpeed / 2;
  }));
  EXPECT_TRUE(wait_for_drive(*can, "Ready to switch on at standstill", [](const StatusAndSpeed& drive) {
    return drive.is(kReadyToSwitchOn) && drive.has(kStandstill);
  }));
}

TEST_F(Motion, Off3StopsQuicklyAndInhibitsSwitchingOn) {
  ASSERT_TRUE(run());

  can->send("205#0B00");

  EXPECT_TRUE(wait_for_state(*can, kQuickStopActive));
  EXPECT_TRUE(wait_for_drive(*can, "Switch on disabled at standstill", [](const StatusAndSpeed& drive) {
    return drive.is(kSwitchOnDisabled) && drive.has(kStandstill);
  }));
}

TEST_F(Motion, DisablingOperationLetsTheMotorCoast) {
  ASSERT_TRUE(run());

  can->send("205#0700");

  EXPECT_TRUE(wait_for_drive(*can, "Switched on while turning", [](const StatusAndSpeed& drive) {
    return drive.is(kSwitchedOn) && !drive.has(kStandstill) && drive.speed > 0;
  }));
  EXPECT_TRUE(wait_for_drive(*can, "Switched on at rest", [](const StatusAndSpeed& drive) {
    return drive.is(kSwitchedOn) && drive.has(kStandstill);
  }));
}

TEST_F(Motion, Off2LetsTheMotorCoastAndInhibitsSwitchingOn) {
  ASSERT_TRUE(run());

  can->send("205#0D00");

  EXPECT_TRUE(wait_for_drive(*can, "Switch on disabled while turning", [](const StatusAndSpeed& drive) {
    return drive.is(kSwitchOnDisabled) && !drive.has(kStandstill);
  }));
}

TEST_F(Motion, HaltStopsAndGoesOnInOperationEnabled) {
  ASSERT_TRUE(can->ask("605#2B5D600001000000", "585#605D600000000000"));  // stop on p1121
  ASSERT_TRUE(run());

  can->send("205#0F01");
  EXPECT_TRUE(wait_for_drive(*can, "Operation enabled at standstill", [](const StatusAndSpeed& drive) {
    return drive.is(kOperationEnabled) && drive.has(kStandstill);
  }));

  can->send("205#0F00");
  EXPECT_TRUE(wait_for_drive(*can, "3000 rpm again", [](const StatusAndSpeed& drive) {
    return drive.is(kOperationEnabled) && std::abs(drive.speed - kFullSpeed) <= kFullSpeed / 1000;
  }));
}

TEST_F(Motion, AnInjectedFaultStopsTheDriveUntilTheMasterAcknowledges) {
  ASSERT_TRUE(run());

  ASSERT_EQ(daemon->axisctl({"fault", "inject", "1", "7860"}).status, 0);

  EXPECT_TRUE(can->expect("085#001081B41E020000"));
  EXPECT_TRUE(wait_for_state(*can, kFault));
  EXPECT_TRUE(can->ask("605#4001100000000000", "585#4F01100081000000"));
  EXPECT_TRUE(can->ask("605#4003100100000000", "585#4303100100100200"));
  can->send("205#8000");
  EXPECT_TRUE(can->expect("085#0000000000000000"));
  EXPECT_TRUE(wait_for_state(*can, kSwitchOnDisabled));
}

}  // namespace
}  // namespace e2e
