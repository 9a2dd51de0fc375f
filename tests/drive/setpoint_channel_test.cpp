// The setpoint channel by itself: which setpoint, within which limits, in front of and behind the ramp.
#include "drive/setpoint_channel/setpoint_channel.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "drive/base/units.hpp"
#include "drive/jog/jog.hpp"

namespace drive {
namespace {

constexpr double kStep = 0.004;

/// A channel without ramps, with limits of 3000 rpm and fixed setpoints of ten times their number (rad/s).
struct Channel {
  SetpointChannel channel;
  SetpointChannel::Settings& parameters = channel.settings;
  SetpointChannel::Inputs& inputs = channel.inputs;
  double motor_maximum_speed = 500.0;
  Jog jog;
  bool jogs = false;

  Channel() {
    parameters.maximum_speed = 300.0;
    parameters.speed_limit_positive = 1000.0;
    parameters.speed_limit_negative = -1000.0;
    parameters.ramp_up_time = parameters.ramp_down_time = 0.0;
    jog.settings = {.speed_1 = 15.0, .speed_2 = -16.0};
    FixedSetpoints& fixed = parameters.fixed;
    for (std::size_t i = 1; i < fixed.size(); ++i) fixed[i] = 10.0 * static_cast<double>(i);
    configure();
  }
  Channel(const Channel&) = delete;
  Channel& operator=(const Channel&) = delete;
  void configure() { channel.configure(motor_maximum_speed); }
  /// A cycle; the setpoint behind the channel.
  double cycle() {
    channel.begin_cycle();
    channel.choose(jogs ? std::optional{jog.setpoint()} : std::nullopt);
    channel.follow();
    return step();
  }
  double step() {
    channel.plan();
    return channel.step(kStep);
  }
  double cycles(int count) {
    for (int i = 1; i < count; ++i) cycle();
    return cycle();
  }
};

TEST(SetpointChannel, AddsMainAndSupplementarySetpoint) {
  Channel c;
  c.inputs.main_setpoint = 100.0;
  c.inputs.supplementary_setpoint = -30.0;
  EXPECT_DOUBLE_EQ(c.cycle(), 70.0);
  EXPECT_DOUBLE_EQ(c.channel.sum(), 70.0);
  EXPECT_DOUBLE_EQ(c.channel.directed(), 70.0);
  EXPECT_DOUBLE_EQ(c.channel.input(), 70.0);
  EXPECT_DOUBLE_EQ(c.channel.output(), 70.0);
}

TEST(SetpointChannel, ChoosesAFixedSetpointByFourBits) {
  for (unsigned number = 0; number < 16; ++number) {
    Channel c;
    c.inputs.fixed_setpoint_bit_0 = (number & 1U) != 0;
    c.inputs.fixed_setpoint_bit_1 = (number & 2U) != 0;
    c.inputs.fixed_setpoint_bit_2 = (number & 4U) != 0;
    c.inputs.fixed_setpoint_bit_3 = (number & 8U) != 0;
    EXPECT_EQ(c.cycle(), 0.0) << "it leads only if p1070 is r1024";
    EXPECT_DOUBLE_EQ(c.channel.fixed_setpoint(), 10.0 * number);
  }
}

TEST(SetpointChannel, InvertsBeforeItInhibitsDirections) {
  struct Case {
    bool invert, inhibit_negative, inhibit_positive;
    double forward, backward;  ///< what 100 and -100 become
  };
  for (const Case& row :
       {Case{false, false, false, 100, -100}, Case{true, false, false, -100, 100},
        Case{false, true, false, 100, 0}, Case{false, false, true, 0, -100}, Case{true, true, false, 0, 100},
        Case{true, false, true, -100, 0}, Case{false, true, true, 0, 0}, Case{true, true, true, 0, 0}}) {
    Channel c;
    c.inputs.invert_setpoint = row.invert;
    c.inputs.inhibit_negative = row.inhibit_negative;
    c.inputs.inhibit_positive = row.inhibit_positive;
    c.inputs.main_setpoint = 100.0;
    EXPECT_DOUBLE_EQ(c.cycle(), row.forward);
    EXPECT_DOUBLE_EQ(c.channel.sum(), 100.0) << "r1078 is in front of them";
    EXPECT_DOUBLE_EQ(c.channel.directed(), row.forward);
    c.inputs.main_setpoint = -100.0;
    EXPECT_DOUBLE_EQ(c.cycle(), row.backward);
  }
}

TEST(SetpointChannel, KeepsTheMinimumSpeedInItsDirection) {
  Channel c;
  c.parameters.minimum_speed = 20.0;
  c.configure();
  for (const auto& [wanted, gets] : {std::pair{5.0, 20.0}, std::pair{-5.0, -20.0}, std::pair{20.0, 20.0},
                                     std::pair{-21.0, -21.0}, std::pair{0.0, 20.0}}) {
    c.inputs.main_setpoint = wanted;
    EXPECT_DOUBLE_EQ(c.cycle(), gets) << wanted;
  }
  c.inputs.enable_setpoint = false;
  EXPECT_EQ(c.cycle(), 0.0);
}

TEST(SetpointChannel, LimitsByTheSmallestOfItsLimitsInEachDirection) {
  struct Case {
    double maximum, motor, positive, negative, wired_forward, wired_backward;
    double forward, backward;
  };
  constexpr double kFree = SetpointChannel::kAsParameter;
  for (const Case& row :
       {Case{300, 500, 1000, -1000, kFree, kFree, 300, -300}, Case{300, 250, 1000, -1000, kFree, kFree, 250, -250},
        Case{300, 500, 200, -100, kFree, kFree, 200, -100}, Case{300, 500, 200, -100, 150, -50, 150, -50},
        Case{300, 500, 200, -100, 250, -280, 250, -280}, Case{300, 500, 200, -100, 900, -900, 300, -300},
        Case{300, 500, 0, 0, kFree, kFree, 0, 0}, Case{300, 500, 200, -100, -20, 20, 0, 0}}) {
    Channel c;
    c.parameters.maximum_speed = row.maximum;
    c.motor_maximum_speed = row.motor;
    c.parameters.speed_limit_positive = row.positive;
    c.parameters.speed_limit_negative = row.negative;
    c.configure();
    c.inputs.forward_limit = row.wired_forward;
    c.inputs.backward_limit = row.wired_backward;
    c.inputs.main_setpoint = 1e6;
    EXPECT_DOUBLE_EQ(c.cycle(), row.forward);
    c.inputs.main_setpoint = -1e6;
    EXPECT_DOUBLE_EQ(c.cycle(), row.backward);
    c.inputs.main_setpoint = 0.0;
    c.inputs.speed_setpoint_1 = 1e6;
    EXPECT_DOUBLE_EQ(c.cycle(), row.forward) << "behind the ramp too";
    c.inputs.speed_setpoint_1 = -1e6;
    EXPECT_DOUBLE_EQ(c.cycle(), row.backward);
  }
}

TEST(SetpointChannel, LetsJogSpeedsLeadWhileItJogs) {
  Channel c;
  c.inputs.main_setpoint = 100.0;
  c.jog.inputs.jog_1 = true;
  EXPECT_DOUBLE_EQ(c.cycle(), 100.0) << "it does not jog";
  c.jogs = true;
  EXPECT_DOUBLE_EQ(c.cycle(), 15.0);
  c.jog.inputs.jog_2 = true;
  EXPECT_EQ(c.cycle(), 0.0) << "both";
  c.jog.inputs.jog_1 = false;
  EXPECT_DOUBLE_EQ(c.cycle(), -16.0);
  c.jog.inputs.jog_2 = false;
  EXPECT_EQ(c.cycle(), 0.0);
}

/// The same with a ramp of 300 rad/s in 3 s: 0.4 rad/s a cycle.
struct RampChannel : Channel {
  static constexpr double kPerCycle = 0.4;
  RampChannel() {
    parameters.ramp_up_time = parameters.ramp_down_time = 3.0;
    configure();
    inputs.main_setpoint = 100.0;
  }
};

TEST(SetpointChannel, FollowsItsRampAndPassesIt) {
  RampChannel c;
  EXPECT_NEAR(c.cycles(10), 10 * c.kPerCycle, 1e-9);
  EXPECT_NEAR(c.channel.acceleration(), 100.0, 1e-9);
  c.inputs.bypass_ramp = true;
  EXPECT_DOUBLE_EQ(c.cycle(), 100.0) << "p1122";
  c.inputs.main_setpoint = -50.0;
  EXPECT_DOUBLE_EQ(c.cycle(), -50.0);
  c.inputs.bypass_ramp = false;
  c.inputs.main_setpoint = 0.0;
  EXPECT_NEAR(c.cycle(), -50.0 + c.kPerCycle, 1e-9);
}

TEST(SetpointChannel, IsZeroAtOnceWithoutRampEnable) {
  RampChannel c;
  c.cycles(10);
  c.inputs.enable_ramp = false;
  EXPECT_EQ(c.cycle(), 0.0);
  EXPECT_EQ(c.channel.acceleration(), 0.0);
  EXPECT_DOUBLE_EQ(c.channel.input(), 100.0);
  c.inputs.enable_ramp = true;
  EXPECT_NEAR(c.cycles(2), 2 * c.kPerCycle, 1e-9) << "and begins again there";
}

TEST(SetpointChannel, WaitsWhereItIsWithoutContinue) {
  RampChannel c;
  const double before = c.cycles(10);
  c.inputs.continue_ramp = false;
  EXPECT_DOUBLE_EQ(c.cycles(20), before);
  EXPECT_EQ(c.channel.acceleration(), 0.0);
  c.inputs.continue_ramp = true;
  EXPECT_NEAR(c.cycle(), before + c.kPerCycle, 1e-9);
}

TEST(SetpointChannel, GoesDownItsRampWithoutSetpointEnable) {
  RampChannel c;
  const double before = c.cycles(10);
  c.inputs.enable_setpoint = false;
  EXPECT_NEAR(c.cycle(), before - c.kPerCycle, 1e-9);
  EXPECT_EQ(c.cycles(20), 0.0);
}

TEST(SetpointChannel, HasTheSettingValueWhileItIsSet) {
  RampChannel c;
  c.inputs.ramp_setting = 60.0;
  EXPECT_NEAR(c.cycle(), c.kPerCycle, 1e-9);
  c.inputs.set_ramp = true;
  EXPECT_DOUBLE_EQ(c.cycle(), 60.0);
  EXPECT_DOUBLE_EQ(c.cycles(5), 60.0);
  c.inputs.ramp_setting = -5000.0;
  EXPECT_DOUBLE_EQ(c.cycle(), -300.0) << "within the limits";
  c.inputs.enable_ramp = false;
  EXPECT_EQ(c.cycle(), 0.0) << "p1140 = 0 is stronger";
  c.inputs.enable_ramp = true;
  c.inputs.ramp_setting = 60.0;
  c.cycle();
  c.inputs.set_ramp = false;
  EXPECT_NEAR(c.cycle(), 60.0 + c.kPerCycle, 1e-9) << "and goes on from there";
}

TEST(SetpointChannel, AddsSetpointsBehindTheRampAtOnce) {
  RampChannel c;
  c.inputs.main_setpoint = 0.0;
  c.inputs.speed_setpoint_1 = 40.0;
  c.inputs.speed_setpoint_2 = -10.0;
  EXPECT_DOUBLE_EQ(c.cycle(), 30.0);
  EXPECT_EQ(c.channel.output(), 0.0) << "r1150 is in front of them";
}

TEST(SetpointChannel, BrakesWithoutTheSetpointsBehindTheRampAndWithoutAJump) {
  for (const Ramp ramp : {Ramp::Off1, Ramp::Off3}) {
    RampChannel c;
    c.parameters.off3_ramp_down_time = 1.5;
    c.configure();
    c.inputs.main_setpoint = 4.0;
    c.inputs.speed_setpoint_1 = 40.0;
    const double before = c.cycles(20);
    ASSERT_NEAR(before, 44.0, 1e-9);

    const double slope = ramp == Ramp::Off1 ? 100.0 : 200.0;
    c.channel.brake(ramp, before);
    c.channel.follow_zero();
    EXPECT_NEAR(c.step(), before - slope * kStep, 1e-9);
    for (int i = 0; i < 200; ++i) c.step();
    EXPECT_EQ(c.channel.total(), 0.0);
  }
}

TEST(SetpointChannel, BeginsASpeedThatItTookOver) {
  RampChannel c;
  c.inputs.speed_setpoint_1 = 10.0;
  c.cycle();
  c.channel.track(80.0);
  EXPECT_DOUBLE_EQ(c.channel.total(), 80.0);
  EXPECT_NEAR(c.cycle(), 80.0 + c.kPerCycle, 1e-9);
}

}  // namespace
}  // namespace drive
