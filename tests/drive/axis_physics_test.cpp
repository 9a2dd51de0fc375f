/// What the motor behind an axis shows of itself: displays, holding brake, motor data, DC link.
#include <cmath>
#include <numbers>
#include <optional>

#include <gtest/gtest.h>

#include "drive/drive_unit.hpp"
#include "tests/drive/test_axis.hpp"

namespace drive {
namespace {

double shown(const Axis& axis, std::uint16_t number, std::size_t index = 0) {
  return axis.read(number, index).value();
}

TEST(AxisDisplays, AgreeWithEachOtherUnderLoad) {
  TestAxis drive;
  drive.axis.set_load_torque(7.0);
  drive.turn_at(1500.0);

  const double field = shown(drive.axis, 29);
  const double torque_current = shown(drive.axis, 30);
  EXPECT_NEAR(shown(drive.axis, 27), std::hypot(field, torque_current), 0.01);
  EXPECT_NEAR(shown(drive.axis, 31), 7.13, 0.05);  // load and friction
  EXPECT_NEAR(shown(drive.axis, 24), 1500.0 / 60.0 * 4.0, 0.01);
  EXPECT_NEAR(torque_current * 1.472, 7.13, 0.1);  // cold torque constant
  const double shaft = 7.13 * 1500.0 * kRpm;
  const double copper = 3.0 * 0.55 * torque_current * torque_current;
  EXPECT_NEAR(1000.0 * shown(drive.axis, 32), shaft + copper, 0.01 * shaft);
  // Induced voltage and resistance, the inductance across: between lines, rms.
  const double frequency = 2.0 * std::numbers::pi * 100.0;
  const double along = 0.17348 * frequency + 0.55 * torque_current * std::numbers::sqrt2;
  const double across = 5.5e-3 * frequency * torque_current * std::numbers::sqrt2;
  EXPECT_NEAR(shown(drive.axis, 25), std::hypot(along, across) * std::sqrt(1.5), 1.0);
  EXPECT_NEAR(shown(drive.axis, 28), 100.0 * std::hypot(along, across) / (540.0 / std::numbers::sqrt3), 0.5);
  EXPECT_EQ(shown(drive.axis, 26), 540.0);
  double sum = 0.0;
  for (std::size_t phase = 0; phase < 3; ++phase) sum += shown(drive.axis, 69, phase);
  EXPECT_NEAR(sum, 0.0, 1e-5);
}

TEST(AxisDisplays, ShowTheHeatOfALoad) {
  TestAxis drive;
  drive.axis.set_load_torque(10.0);
  drive.turn_at(500.0);
  drive.run(60.0);

  EXPECT_GT(shown(drive.axis, 34), 0.5);
  EXPECT_GT(shown(drive.axis, 35), 24.0);
  EXPECT_GT(shown(drive.axis, 36), 5.0);
  EXPECT_GT(shown(drive.axis, 37, 1), shown(drive.axis, 37, 0));
  EXPECT_EQ(shown(drive.axis, 67, 1), 36.0);
}

TEST(AxisDisplays, CountTheEnergyOfBrakingApart) {
  TestAxis drive{{.load = {.inertia = 0.01}}};
  drive.turn_at(3000.0);
  const double drawn = shown(drive.axis, 39, 1);
  const double kinetic = 0.5 * 0.01151 * std::pow(3000.0 * kRpm, 2) / 3.6e6;
  EXPECT_GT(drawn, kinetic);

  drive.send(0x000B);
  drive.run(0.5);

  const double fed_back = shown(drive.axis, 39, 2);
  EXPECT_GT(fed_back, 0.5 * kinetic);
  EXPECT_LT(fed_back, kinetic);
  EXPECT_NEAR(shown(drive.axis, 39, 0), shown(drive.axis, 39, 1) - fed_back, 1e-9);
}

TEST(AxisDisplays, CountNoEnergyOfAMotorThatStandsWithItsPulsesOff) {
  TestAxis drive{{.load = {.coulomb_friction = 60.0}}};
  drive.enable(100.0);
  drive.run(0.2);
  ASSERT_GT(shown(drive.axis, 32), 0.1) << "it pushes against its friction";

  drive.send(0x0000);
  drive.run(0.1);
  const double drawn = shown(drive.axis, 39, 1);
  const double fed_back = shown(drive.axis, 39, 2);
  drive.run(10.0);

  EXPECT_EQ(shown(drive.axis, 32), 0.0);
  EXPECT_EQ(shown(drive.axis, 39, 1), drawn);
  EXPECT_EQ(shown(drive.axis, 39, 2), fed_back);
}

struct Hoist : testing::Test {
  static constexpr double kWeight = 5.0;  // N·m
  TestAxis drive{{.load = {.inertia = 0.002, .constant_torque = kWeight, .brake = {.torque = 20.0}}}};
  std::int64_t place() const { return drive.axis.actual().encoder_counts; }
};

TEST_F(Hoist, IsHeldByItsBrakeWithoutCurrent) {
  drive.send(0x0000);
  drive.run(5.0);

  EXPECT_EQ(place(), 0);
  EXPECT_EQ(shown(drive.axis, 27), 0.0);
}

TEST_F(Hoist, DoesNotDropWhenTheBrakeOpensOrCloses) {
  constexpr double kDegree = 2048.0 * 2048.0 / 360.0;  // increments
  drive.enable(0.0);
  drive.run(1.0);
  EXPECT_NEAR(static_cast<double>(place()), 0.0, 5.0 * kDegree);
  EXPECT_NEAR(drive.axis.actual().torque, kWeight, 0.5);

  const auto before = place();
  drive.send(0x0006);  // OFF1
  drive.run(2.0);
  EXPECT_FALSE(drive.axis.actual().pulses_enabled);
  EXPECT_NEAR(static_cast<double>(place() - before), 0.0, 5.0 * kDegree);
}

TEST_F(Hoist, WaitsForItsBrakeBeforeItMoves) {
  drive.enable(100.0);
  EXPECT_EQ(drive.demand_rpm(), 0.0);
  drive.run(0.5);
  EXPECT_GT(drive.demand_rpm(), 0.0);
}

TEST(EncoderDefects, AreAcknowledgedOnceTheyAreGone) {
  TestAxis drive;
  drive.turn_at(1000.0);
  drive.axis.fail_encoder(motor::EncoderDefect::LostPulses);
  drive.run(0.5);
  ASSERT_EQ(drive.axis.messages().faults().size(), 1U);
  EXPECT_EQ(drive.axis.messages().faults()[0].row->number, 31100);
  EXPECT_GT(drive.axis.messages().faults()[0].value, 0U);
  EXPECT_FALSE(drive.axis.actual().pulses_enabled);

  drive.axis.fail_encoder(motor::EncoderDefect::None);
  EXPECT_TRUE(drive.axis.acknowledge());
  drive.run(0.1);
  EXPECT_TRUE(drive.axis.messages().faults().empty());

  drive.axis.fail_encoder(motor::EncoderDefect::Loss);
  drive.run(0.1);
  EXPECT_FALSE(drive.axis.acknowledge()) << "it is still there";
}

TEST(MotorData, ThatCannotBeRaiseF07950AndTheMotorTurnsOnWithTheOldOnes) {
  TestAxis drive;
  ASSERT_TRUE(drive.axis.write(10, 3.0));
  ASSERT_TRUE(drive.axis.write(350, 0.0));
  drive.send(0x0000);
  EXPECT_TRUE(drive.axis.messages().faults().empty()) << "not before commissioning ends";
  ASSERT_TRUE(drive.axis.write(10, 0.0));
  drive.send(0x0000);

  ASSERT_EQ(drive.axis.messages().faults().size(), 1U);
  EXPECT_EQ(drive.axis.messages().faults()[0].row->number, 7950);
  EXPECT_EQ(drive.axis.messages().faults()[0].value, 350U);

  ASSERT_TRUE(drive.axis.write(350, 0.55));
  drive.send(0x0000);
  EXPECT_TRUE(drive.axis.acknowledge());
  drive.turn_at(1000.0);
  EXPECT_NEAR(drive.rpm(), 1000.0, 1.0);
}

TEST(MotorData, LetP0340ComputeTheControllersAnew) {
  Axis axis{AxisConfiguration{}};
  const double gain = shown(axis, 1460);
  ASSERT_TRUE(axis.write(342, 3.0));
  ASSERT_TRUE(axis.write(340, 4.0));
  EXPECT_NEAR(shown(axis, 1460), 3.0 * gain, 1e-3 * gain);
  EXPECT_EQ(shown(axis, 340), 0.0);
}

TEST(MotorData, LetP0340FindTheCircuitOfAnInductionMotorFromItsPlate) {
  const motor::MachineData motor{.type = motor::MachineType::Induction,
                                 .pole_pairs = 2,
                                 .rated_voltage = 400.0,
                                 .rated_current = 4.55,
                                 .rated_power = 2200.0,
                                 .power_factor = 0.81,
                                 .rated_frequency = 50.0,
                                 .rated_speed = 1455.0 * kRpm,
                                 .maximum_speed = 4200.0 * kRpm,
                                 .rated_torque = 14.44,
                                 .maximum_torque = 30.0,
                                 .maximum_current = 9.1,
                                 .stator_resistance = 9.0,  // far from the truth
                                 .inertia = 0.014};
  Axis axis{{.machine = motor}};
  ASSERT_EQ(shown(axis, 350), 9.0);

  ASSERT_TRUE(axis.write(340, 2.0));

  EXPECT_NEAR(shown(axis, 350), 2.1, 0.7);
  EXPECT_NEAR(shown(axis, 354), 1.8, 0.4);
  EXPECT_NEAR(shown(axis, 360), 294.0, 60.0);
}

/// Axes that share a DC link.
struct Link {
  static constexpr double kCycle = 0.004;  // s
  DriveUnit unit{{.axes = {{.load = {.inertia = 0.02}}, {.load = {.coulomb_friction = 10.0}}},
                  .node_id = 5,
                  .supply = {.chopper_resistance = 0.0}}};
  double highest = 0.0;  // V

  void run(std::uint16_t first, std::uint16_t second, double rpm, double seconds) {
    const std::array<std::optional<Setpoints>, 2> wanted{Setpoints{.controlword = first, .speed = rpm * kRpm},
                                                         Setpoints{.controlword = second, .speed = rpm * kRpm}};
    for (double time = 0.0; time < seconds; time += kCycle) {
      unit.cycle(wanted, kCycle);
      highest = std::max(highest, unit.dc_link().voltage());
    }
  }
  void turn(bool second) {
    for (const int word : {0x06, 0x06, 0x07, 0x0F})
      run(static_cast<std::uint16_t>(word), static_cast<std::uint16_t>(second ? word : 0), 1500.0, kCycle);
    run(0x0F, static_cast<std::uint16_t>(second ? 0x0F : 0), 1500.0, 4.0);
  }
};

TEST(DcLinkOfAUnit, SagsWithTheLoadAndIsTheSameForAll) {
  Link link;
  EXPECT_NEAR(link.unit.dc_link().voltage(), 540.0, 1e-9);
  link.turn(true);
  EXPECT_LT(link.unit.dc_link().voltage(), 539.5);
  EXPECT_NEAR(shown(link.unit.axes()[0], 26), shown(link.unit.axes()[1], 26), 1e-6);
}

TEST(DcLinkOfAUnit, LetsOneAxisUseWhatAnotherFeedsBack) {
  Link both;
  both.turn(true);
  both.run(0x0B, 0x0F, 1500.0, 1.0);
  EXPECT_TRUE(both.unit.axes()[0].messages().faults().empty());

  Link alone;
  alone.turn(false);
  alone.run(0x0B, 0, 1500.0, 1.0);
  EXPECT_GT(alone.highest, both.highest + 20.0);
}

TEST(DcLinkOfAUnit, LosesItsVoltageWithTheLineUntilTheAxesTrip) {
  Link link;
  link.turn(true);
  link.unit.set_line_voltage(0.0);
  link.run(0x0F, 0x0F, 1500.0, 2.0);

  for (const Axis& axis : link.unit.axes()) {
    ASSERT_EQ(axis.messages().faults().size(), 1U);
    EXPECT_EQ(axis.messages().faults()[0].row->number, 30003);
  }
}

}  // namespace
}  // namespace drive
