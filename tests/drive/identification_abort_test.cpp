/// What ends a motor identification early: commands, faults, defects. Nothing is left half set.
#include <array>
#include <functional>
#include <string>

#include "drive/axis/axis_step.hpp"
#include "drive/drive_unit.hpp"
#include "drive/images/storage_image.hpp"
#include "tests/drive/measuring_axis.hpp"
#include "tests/drive/wired_axis.hpp"

namespace drive {
namespace {

/// What r1912 to r1984 show.
std::array<double, 12> results_of(const MeasuringAxis& drive) {
  constexpr std::array<std::uint16_t, 12> kShown{1912, 1913, 1914, 1925, 1927, 1932,
                                                 1934, 1936, 1937, 1969, 1984, 47};
  std::array<double, 12> values{};
  for (std::size_t i = 0; i < kShown.size(); ++i) values[i] = drive.shown(kShown[i]);
  return values;
}

struct Trial {
  std::string motor;
  std::uint16_t parameter;
};
std::string name_of(const testing::TestParamInfo<Trial>& test) {
  std::string name = test.param.motor + "_p" + std::to_string(test.param.parameter);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}
void PrintTo(const Trial& trial, std::ostream* out) {
  *out << trial.motor << " p" << trial.parameter;
}

class IdentificationAbort : public testing::TestWithParam<Trial> {
 protected:
  IdentificationAbort() {
    EXPECT_TRUE(selected_.axis.write(1121, 0.5));
    EXPECT_TRUE(selected_.axis.write(1135, 0.2));
    before_ = selected_.parameters();
    known_ = results_of(selected_);
    EXPECT_TRUE(selected_.axis.write(GetParam().parameter, 1.0));
  }

  /// Calls @p trial with an axis at many instants of the measurement, from its first cycle to its last.
  void at_many_instants(const std::function<void(MeasuringAxis&)>& trial) {
    MeasuringAxis drive = selected_;
    drive.on();
    int instants = 0;
    for (int cycle = 0; drive.state() == State::OperationEnabled; ++cycle) {
      if (cycle % 41 == 0) {
        SCOPED_TRACE(testing::Message() << "after " << cycle << " cycles, r0047 = " << drive.shown(47));
        MeasuringAxis at_once = drive;
        trial(at_once);
        ++instants;
      }
      drive.send(0x000F);
    }
    EXPECT_GT(instants, 8);
    EXPECT_TRUE(drive.axis.messages().faults().empty());
  }
  void expect_old_parameters(const MeasuringAxis& drive) {
    EXPECT_EQ(drive.parameters(), before_);
    std::array<double, 12> shown = results_of(drive);
    shown.back() = known_.back();
    EXPECT_EQ(shown, known_);
    EXPECT_FALSE(drive.axis.identification().leads());
  }
  /// What a defect did not disturb is right.
  void expect_right_parameters(const MeasuringAxis& drive) {
    MeasuringAxis sound = selected_;
    sound.on(), sound.wait();
    for (const std::uint16_t number : std::array<std::uint16_t, 6>{316, 342, 350, 354, 356, 360})
      EXPECT_NEAR(drive.shown(number), sound.shown(number), 0.02 * sound.shown(number)) << number;
  }
  std::uint16_t alarm() const { return GetParam().parameter == kP1910 ? 7991 : 7980; }

  MeasuringAxis selected_{real_axis(GetParam().motor, kOther)};
  std::vector<double> before_;
  std::array<double, 12> known_{};
};

TEST_P(IdentificationAbort, LeavesTheSelectionAfterAnOffAndBeginsAnewWithTheNextOn) {
  struct Command {
    std::uint16_t word;
    State ends_in;
  };
  constexpr std::array kCommands{Command{0x0006, State::ReadyToSwitchOn}, Command{0x000D, State::SwitchOnDisabled},
                                 Command{0x000B, State::SwitchOnDisabled}, Command{0x0007, State::SwitchedOn}};
  int instant = 0;
  at_many_instants([&](MeasuringAxis& drive) {
    const Command command = kCommands[static_cast<std::size_t>(instant++) % kCommands.size()];
    SCOPED_TRACE(command.word);
    drive.send(command.word);
    expect_old_parameters(drive);
    drive.run_until([&](const Axis& axis) { return axis.actual().state == command.ends_in; }, 3.0);
    EXPECT_EQ(drive.state(), command.ends_in);
    EXPECT_TRUE(drive.axis.messages().faults().empty());
    EXPECT_EQ(drive.shown(GetParam().parameter), 1.0);
    EXPECT_TRUE(drive.has(alarm()));
    expect_old_parameters(drive);
    drive.send(0x0006), drive.run(4.0);
    if (instant % 5 != 1) return;
    drive.on();
    drive.wait();
    EXPECT_EQ(drive.state(), State::SwitchOnDisabled);
    EXPECT_EQ(drive.shown(GetParam().parameter), 0.0);
    EXPECT_TRUE(drive.axis.messages().faults().empty());
  });
}

TEST_P(IdentificationAbort, TakesTheSelectionBackAfterAFault) {
  constexpr std::array<std::uint16_t, 3> kFaults{7220, 30001, 8701};  // OFF1, OFF2, OFF3
  int instant = 0;
  at_many_instants([&](MeasuringAxis& drive) {
    const std::uint16_t fault = kFaults[static_cast<std::size_t>(instant++) % kFaults.size()];
    SCOPED_TRACE(fault);
    ASSERT_TRUE(drive.axis.raise(fault));
    EXPECT_NE(drive.state(), State::OperationEnabled);
    drive.run_until([&](const Axis& axis) { return axis.actual().state == State::Fault; }, 3.0);
    EXPECT_EQ(drive.state(), State::Fault);
    EXPECT_EQ(drive.axis.messages().faults().size(), 1U);
    EXPECT_EQ(drive.shown(GetParam().parameter), 0.0);
    EXPECT_FALSE(drive.has(alarm()));
    EXPECT_EQ(drive.shown(47), 0.0);
    expect_old_parameters(drive);
  });
}

TEST_P(IdentificationAbort, EndsWithAnEncoderThatIsLostOrCountsBackwards) {
  for (const motor::EncoderDefect defect : {motor::EncoderDefect::Loss, motor::EncoderDefect::Reversed})
    at_many_instants([&](MeasuringAxis& drive) {
      drive.axis.fail_encoder(defect);
      drive.wait();
      EXPECT_NE(drive.state(), State::OperationEnabled);
      if (drive.axis.messages().faults().empty()) return expect_right_parameters(drive);
      EXPECT_EQ(drive.shown(GetParam().parameter), 0.0);
      EXPECT_FALSE(drive.has(alarm()));
      expect_old_parameters(drive);
    });
}

TEST_P(IdentificationAbort, EndsWithTheDcLink) {
  at_many_instants([&](MeasuringAxis& drive) {
    drive.axis.command(drive.setpoints);
    drive.axis.begin_cycle(MeasuringAxis::kCycle);
    for (int i = 0; i < 32; ++i) drive.axis.step(200.0);
    drive.axis.end_cycle();
    EXPECT_EQ(drive.state(), State::Fault);
    EXPECT_NE(drive.fault(30003), nullptr);
    EXPECT_EQ(drive.shown(GetParam().parameter), 0.0);
    expect_old_parameters(drive);
  });
}

TEST_P(IdentificationAbort, IsForgottenByPowerOffAndByCommissioning) {
  int instant = 0;
  at_many_instants([&](MeasuringAxis& drive) {
    if (instant++ % 2 == 0)
      drive.axis.power_off();
    else
      drive.axis.leave_commissioning();
    drive.send(0x0000);
    EXPECT_EQ(drive.state(), State::SwitchOnDisabled);
    EXPECT_EQ(drive.shown(GetParam().parameter), 0.0);
    EXPECT_FALSE(drive.has(alarm()));
    expect_old_parameters(drive);
  });
}

TEST_P(IdentificationAbort, EndsWhenParametersAreLoaded) {
  at_many_instants([&](MeasuringAxis& drive) {
    ASSERT_TRUE(drive.axis.load(350, 0, drive.shown(350)));
    EXPECT_EQ(drive.state(), State::SwitchOnDisabled);
    EXPECT_EQ(drive.shown(GetParam().parameter), 0.0);
    expect_old_parameters(drive);
  });
}

INSTANTIATE_TEST_SUITE_P(Motors, IdentificationAbort,
                         testing::Values(Trial{"1fk7063", kP1910}, Trial{"1fk7063", kP1960},
                                         Trial{"1le1003-2k2", kP1910}, Trial{"1le1003-2k2", kP1960},
                                         Trial{"1ph8131", kP1910}),
                         name_of);

TEST(IdentificationAborted, GoesOnFromStandstillWhereOnComesBackWhileOff1Brakes) {
  MeasuringAxis drive{real_axis("1fk7063")};
  ASSERT_TRUE(drive.axis.write(1121, 5.0));
  ASSERT_TRUE(drive.axis.write(kP1960, 1.0));
  drive.on();
  drive.run_until([](const Axis& axis) { return std::abs(axis.actual().speed) > 500.0 * kRpm; }, 10.0);
  drive.send(0x0006);
  EXPECT_EQ(drive.state(), State::Off1Braking);
  drive.send(0x000F);
  EXPECT_EQ(drive.state(), State::OperationEnabled);
  EXPECT_EQ(drive.shown(47), 200.0) << "waits";
  drive.wait();
  EXPECT_TRUE(drive.axis.messages().faults().empty());
  EXPECT_EQ(drive.shown(kP1960), 0.0);
  EXPECT_GT(drive.shown(1969), 0.0);
}

TEST(IdentificationAborted, BeginsAnewWhenTheSpeedControllerIsEnabledAgain) {
  WiredAxis drive{real_axis("1fk7063")};
  ASSERT_TRUE(drive.axis.write(1960, 1.0));
  drive.inputs.on = true;
  drive.run(1.0);
  EXPECT_NE(drive.axis.read(47).value(), 200.0);
  drive.inputs.enable_speed_controller = false;
  drive.run(0.1);
  EXPECT_EQ(drive.axis.read(47).value(), 200.0);
  EXPECT_EQ(drive.state(), State::OperationEnabled);
  drive.inputs.enable_speed_controller = true;
  drive.run(60.0);
  EXPECT_EQ(drive.axis.read(1960).value(), 0.0);
  EXPECT_TRUE(drive.axis.messages().faults().empty());
}

}  // namespace
}  // namespace drive
