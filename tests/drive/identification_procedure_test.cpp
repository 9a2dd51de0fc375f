/// How the motor identification of an axis goes from ON to its end, and what stays of it.
#include <array>

#include "drive/drive_unit.hpp"
#include "drive/images/storage_image.hpp"
#include "tests/drive/measuring_axis.hpp"

namespace drive {
namespace {

TEST(RotatingIdentification, DoesWithoutWhatP1959AndP1960LeaveOut) {
  MeasuringAxis drive{real_axis("1fk7063", kOther)};
  const double gain = drive.shown(1460), constant = drive.shown(316);
  ASSERT_TRUE(drive.axis.write(1959, 0x0005));  // encoder, inertia
  drive.measure(kP1960);
  EXPECT_EQ(drive.shown(1460), gain);
  EXPECT_EQ(drive.shown(316), constant);
  EXPECT_GT(drive.shown(1969), 0.0);

  MeasuringAxis vector{real_axis("1le1003-2k2", kOther)};
  const double characteristic = vector.shown(369);
  vector.measure(kP1960, 3.0);
  EXPECT_EQ(vector.state(), State::SwitchOnDisabled);
  EXPECT_EQ(vector.shown(369), characteristic);
  EXPECT_GT(vector.shown(1969), 0.0);
}

TEST(RotatingIdentification, TurnsOnlyWhereItMay) {
  struct Lock {
    double configuration;
    double sign;
  };
  for (const Lock lock : {Lock{0x400F, -1.0}, Lock{0x800F, 1.0}}) {
    MeasuringAxis drive{real_axis("1fk7063")};
    ASSERT_TRUE(drive.axis.write(1959, lock.configuration));
    ASSERT_TRUE(drive.axis.write(kP1960, 1.0));
    double fastest = 0.0, wrong = 0.0;
    drive.on();
    while (drive.state() == State::OperationEnabled) {
      drive.send(0x000F);
      fastest = std::max(fastest, lock.sign * drive.rpm());
      wrong = std::max(wrong, -lock.sign * drive.rpm());
    }
    EXPECT_EQ(drive.state(), State::SwitchOnDisabled);
    EXPECT_GT(fastest, 500.0);
    EXPECT_LT(wrong, 30.0) << "nothing but the rest of a braking";
  }
  MeasuringAxis locked{real_axis("1fk7063")};
  ASSERT_TRUE(locked.axis.write(1959, 0xC00F));
  const std::vector<double> before = locked.parameters();
  locked.measure(kP1960);
  EXPECT_NE(locked.fault(7985), nullptr);
  EXPECT_EQ(locked.parameters(), before);
}

TEST(RotatingIdentification, StaysBelowTheSpeedLimitsOfTheAxis) {
  MeasuringAxis drive{real_axis("1fk7063")};
  ASSERT_TRUE(drive.axis.write(1082, 900.0));
  ASSERT_TRUE(drive.axis.write(kP1960, 1.0));
  drive.on();
  double fastest = 0.0;
  while (drive.state() == State::OperationEnabled) {
    drive.send(0x000F);
    fastest = std::max(fastest, std::abs(drive.rpm()));
  }
  EXPECT_TRUE(drive.axis.messages().faults().empty());
  EXPECT_LT(fastest, 950.0);
}

TEST(Identification, RunsBothOneAfterTheOtherByP1900) {
  MeasuringAxis drive{real_axis("1fk7063", kOther)};
  drive.measure(kP1900);
  EXPECT_EQ(drive.shown(kP1910), 0.0);
  EXPECT_EQ(drive.shown(kP1960), 1.0);
  EXPECT_EQ(drive.shown(kP1900), 1.0);
  EXPECT_FALSE(drive.has(7991));
  EXPECT_TRUE(drive.has(7980)) << "of the second one";

  drive.on();
  EXPECT_EQ(drive.state(), State::OperationEnabled);
  drive.wait();
  EXPECT_EQ(drive.shown(kP1960), 0.0);
  EXPECT_EQ(drive.shown(kP1900), 0.0);
  EXPECT_FALSE(drive.has(7980));
}

TEST(Identification, WaitsForTheHoldingBrake) {
  motor::Load load{};
  load.brake = {.torque = 20.0, .opening_time = 0.2, .closing_time = 0.05};
  MeasuringAxis drive{real_axis("1fk7063", kOther, load)};
  ASSERT_TRUE(drive.axis.write(kP1910, 1.0));

  drive.on();
  EXPECT_EQ(drive.shown(2), 15.0) << "the brake opens";
  drive.run(0.15);
  EXPECT_EQ(drive.shown(47), 300.0);
  drive.run(0.1);
  EXPECT_EQ(drive.shown(2), 14.0);
  drive.wait();
  EXPECT_TRUE(drive.axis.messages().faults().empty());
  EXPECT_NEAR(drive.shown(350), 1.2 * 0.55, 0.02);
}

TEST(Identification, RefusesMotorDataWhileItMeasures) {
  MeasuringAxis drive{real_axis("1fk7063")};
  ASSERT_TRUE(drive.axis.write(kP1960, 1.0));
  drive.on();
  drive.run(0.5);

  EXPECT_EQ(drive.refusal_of(350, 1.0), Refusal::PulsesEnabled);
  EXPECT_EQ(drive.refusal_of(1300, 20.0), Refusal::PulsesEnabled);
  EXPECT_TRUE(drive.axis.write(1460, drive.shown(1460)));
  drive.wait();
  EXPECT_EQ(drive.shown(kP1960), 0.0);
  EXPECT_TRUE(drive.axis.messages().faults().empty());
}

TEST(Identification, SurvivesAsTheSavedParameters) {
  const UnitConfiguration configuration{.axes = {real_axis("1fk7063", kOther), real_axis("1le1003-2k2", kOther)},
                                        .node_id = 5};
  DriveUnit unit{configuration};
  ASSERT_TRUE(unit.object(3)->write(1300, 21.0));
  for (Axis& axis : unit.axes()) ASSERT_TRUE(axis.write(1900, 1.0));
  // Both axes at once, on their common DC link.
  const auto cycle = [&](std::uint16_t word) {
    const std::array<std::optional<Setpoints>, 2> both{Setpoints{.controlword = word},
                                                       Setpoints{.controlword = word}};
    unit.cycle(both, 0.004);
  };
  for (int round = 0; round < 2; ++round) {
    cycle(0x0006), cycle(0x0006), cycle(0x0007), cycle(0x000F);
    int left = 50000;
    while (--left > 0 && (unit.axes()[0].actual().pulses_enabled || unit.axes()[1].actual().pulses_enabled))
      cycle(0x000F);
  }
  for (const Axis& axis : unit.axes()) {
    EXPECT_EQ(axis.read(1900).value(), 0.0);
    EXPECT_TRUE(axis.messages().faults().empty());
    EXPECT_GT(axis.read(1969).value(), 0.0);
  }
  std::vector<std::byte> image(storage_image::size(unit));
  ASSERT_TRUE(storage_image::save(unit, image));

  DriveUnit fresh{configuration};
  ASSERT_TRUE(storage_image::load(fresh, image));

  for (const std::uint8_t object : {std::uint8_t{2}, std::uint8_t{3}}) {
    for (const PlacedRow& placed : parameters_of(unit.object(object)->kind()))
      for (std::size_t i = 0; is_saved(*placed.row) && i < placed.row->count; ++i)
        EXPECT_EQ(fresh.read(object, placed.row->number, i)->bits, unit.read(object, placed.row->number, i)->bits)
            << placed.row->number;
    for (const int number : {316, 342, 350, 354, 356, 357, 358, 360, 362, 369}) {
      const auto parameter = static_cast<std::uint16_t>(number);
      EXPECT_EQ(fresh.object(object)->read(parameter).value(), unit.object(object)->read(parameter).value())
          << number;
    }
  }
}

}  // namespace
}  // namespace drive
