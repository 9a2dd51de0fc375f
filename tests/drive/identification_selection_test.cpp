/// What selects the motor identification of an axis, and what is refused.
#include "tests/drive/explained_axis.hpp"
#include "tests/drive/measuring_axis.hpp"

namespace drive {
namespace {

TEST(IdentificationSelection, ShowsAnAlarmUntilItIsTakenBack) {
  MeasuringAxis drive{real_axis("1fk7063")};

  ASSERT_TRUE(drive.axis.write(kP1910, 1.0));
  EXPECT_TRUE(drive.has(7991));
  EXPECT_FALSE(drive.has(7980));
  EXPECT_EQ(drive.shown(47), 300.0);
  EXPECT_NE(drive.status() & 0x0080, 0) << "alarm";
  ASSERT_TRUE(drive.axis.write(kP1910, 0.0));
  EXPECT_FALSE(drive.has(7991));

  ASSERT_TRUE(drive.axis.write(kP1960, 1.0));
  EXPECT_TRUE(drive.has(7980));
  EXPECT_EQ(drive.shown(47), 200.0);
  ASSERT_TRUE(drive.axis.write(kP1960, 0.0));
  EXPECT_FALSE(drive.has(7980));
  EXPECT_EQ(drive.shown(47), 0.0);
  drive.send(0x0006);
  EXPECT_EQ(drive.status() & 0x0080, 0);
}

TEST(IdentificationSelection, TakesBothByP1900AndGoesBackTo0WithTheLastOfThem) {
  MeasuringAxis drive{real_axis("1fk7063")};

  ASSERT_TRUE(drive.axis.write(kP1900, 1.0));
  EXPECT_EQ(drive.shown(kP1910), 1.0);
  EXPECT_EQ(drive.shown(kP1960), 1.0);
  EXPECT_TRUE(drive.has(7991) && drive.has(7980));
  ASSERT_TRUE(drive.axis.write(kP1910, 0.0));
  EXPECT_EQ(drive.shown(kP1900), 1.0);
  ASSERT_TRUE(drive.axis.write(kP1960, 0.0));
  EXPECT_EQ(drive.shown(kP1900), 0.0);

  ASSERT_TRUE(drive.axis.write(kP1900, 2.0));
  EXPECT_EQ(drive.shown(kP1910), 1.0);
  EXPECT_EQ(drive.shown(kP1960), 0.0);
  ASSERT_TRUE(drive.axis.write(kP1900, 0.0));
  EXPECT_EQ(drive.shown(kP1910), 0.0);
  EXPECT_FALSE(drive.has(7991));
}

TEST(IdentificationSelection, RefusesValuesThatTheAxisDoesNotHave) {
  MeasuringAxis servo{real_axis("1fk7063")};
  MeasuringAxis vector{real_axis("1le1003-2k2")};
  for (int value = -3; value <= 28; ++value) {
    const bool of_a_servo = value >= -1 && value <= 1;
    EXPECT_EQ(servo.refusal_of(kP1910, value), value == -3  ? Refusal::NotNow
                                               : of_a_servo ? Refusal::NoParameter
                                                            : Refusal::IllegalValue)
        << value;
    EXPECT_EQ(vector.refusal_of(kP1910, value), value == -3                              ? Refusal::NotNow
                                                : of_a_servo || value == 2 || value == 3 ? Refusal::NoParameter
                                                                                         : Refusal::IllegalValue)
        << value;
  }
  for (int value = -3; value <= 4; ++value) {
    const bool of_a_servo = value >= -1 && value <= 1;
    EXPECT_EQ(servo.refusal_of(kP1960, value), value == -3  ? Refusal::NotNow
                                               : of_a_servo ? Refusal::NoParameter
                                                            : Refusal::IllegalValue)
        << value;
    const bool blind = value == 2 || value == 4;
    EXPECT_EQ(vector.refusal_of(kP1960, value), value == -3 || blind       ? Refusal::NotNow
                                                : of_a_servo || value >= 1 ? Refusal::NoParameter
                                                                           : Refusal::IllegalValue)
        << value;
  }
  EXPECT_EQ(servo.refusal_of(kP1910, 29.0), Refusal::AboveMaximum);
  EXPECT_EQ(servo.refusal_of(kP1910, -4.0), Refusal::BelowMinimum);
  EXPECT_EQ(servo.refusal_of(kP1960, 5.0), Refusal::AboveMaximum);
}

TEST(IdentificationSelection, OfAVectorAxisNamesWhetherTheEncoderCounts) {
  MeasuringAxis drive{real_axis("1le1003-2k2")};
  for (const double mode : {21.0, 23.0}) {
    ASSERT_TRUE(drive.axis.write(1300, mode));
    for (const double value : {1.0, 3.0}) EXPECT_TRUE(drive.axis.write(kP1960, value)) << value;
    for (const double value : {2.0, 4.0}) EXPECT_EQ(drive.refusal_of(kP1960, value), Refusal::NotNow) << value;
  }
  ASSERT_TRUE(drive.axis.write(1300, 20.0));
  EXPECT_EQ(drive.shown(kP1960), 0.0) << "with the encoder, which does not count any more";
  EXPECT_FALSE(drive.has(7980));
  for (const double value : {1.0, 3.0}) EXPECT_EQ(drive.refusal_of(kP1960, value), Refusal::NotNow) << value;
  for (const double value : {2.0, 4.0}) EXPECT_TRUE(drive.axis.write(kP1960, value)) << value;
  ASSERT_TRUE(drive.axis.write(kP1960, 0.0));
  ASSERT_TRUE(drive.axis.write(kP1900, 1.0));
  EXPECT_EQ(drive.shown(kP1960), 2.0) << "of the kind that fits";
}

TEST(IdentificationSelection, LetsNothingRotateUnderVoltageFrequencyControl) {
  MeasuringAxis drive{real_axis("1le1003-2k2")};
  ASSERT_TRUE(drive.axis.write(kP1960, 1.0));

  ASSERT_TRUE(drive.axis.write(1300, 0.0));

  EXPECT_EQ(drive.shown(kP1960), 0.0);
  EXPECT_FALSE(drive.has(7980));
  EXPECT_EQ(drive.refusal_of(kP1960, 1.0), Refusal::NotNow);
  ASSERT_TRUE(drive.axis.write(kP1900, 1.0));
  EXPECT_EQ(drive.shown(kP1910), 1.0);
  EXPECT_EQ(drive.shown(kP1960), 0.0);
}

TEST(IdentificationSelection, NeedsPulsesOff) {
  MeasuringAxis drive{real_axis("1fk7063")};
  drive.enable();

  EXPECT_EQ(drive.refusal_of(kP1910, 1.0), Refusal::PulsesEnabled);
  EXPECT_EQ(drive.refusal_of(kP1960, 1.0), Refusal::PulsesEnabled);
  EXPECT_EQ(drive.refusal_of(kP1900, 1.0), Refusal::PulsesEnabled);
}

TEST(IdentificationSelection, IsNotStartedByJog) {
  WiredAxis drive{real_axis("1fk7063")};
  ASSERT_TRUE(drive.axis.write(1910, 1.0));
  ASSERT_TRUE(drive.axis.write(1058, 100.0));
  drive.inputs.jog_1 = true;
  drive.run(0.5);

  EXPECT_EQ(drive.state(), State::OperationEnabled);
  EXPECT_NEAR(drive.rpm(), 100.0, 2.0);
  EXPECT_TRUE(drive.has(7991));
}

TEST(IdentificationSelection, IsToldByExplain) {
  MeasuringAxis drive{real_axis("1fk7063")};
  ASSERT_TRUE(drive.axis.write(kP1910, 1.0));
  drive.send(0x0006);
  EXPECT_NE(told(drive.axis).find("p1910 (A07991) is selected"), std::string::npos) << told(drive.axis);

  drive.on();
  drive.run(0.1);
  EXPECT_NE(told(drive.axis).find("The motor is being measured by p1910"), std::string::npos) << told(drive.axis);
}

}  // namespace
}  // namespace drive
