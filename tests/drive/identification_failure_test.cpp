/// Motor identification that cannot succeed: the right fault with its value, and the old parameters stay.
#include <algorithm>
#include <cmath>
#include <iostream>

#include "drive/machine/machine_model.hpp"
#include "motor/control/field/induction_circuit.hpp"
#include "tests/drive/measuring_axis.hpp"

namespace drive {
namespace {

using motor::StandstillFault;
namespace step = motor::measurement_step;

/// F07990 with @p value, and nothing else has happened.
void expect_standstill_fault(MeasuringAxis& drive, StandstillFault value) {
  const std::vector<double> before = drive.parameters();
  drive.measure(kP1910);
  ASSERT_NE(drive.fault(7990), nullptr);
  EXPECT_EQ(drive.fault(7990)->value, static_cast<std::uint32_t>(value));
  EXPECT_EQ(drive.state(), State::Fault);
  EXPECT_EQ(drive.shown(kP1910), 0.0);
  EXPECT_EQ(drive.shown(1912), 0.0);
  EXPECT_FALSE(drive.has(7991));
  EXPECT_EQ(drive.parameters(), before);
}

/// F07985 with @p value; its reaction is OFF1.
void expect_rotating_fault(MeasuringAxis& drive, std::uint16_t value) {
  const std::vector<double> before = drive.parameters();
  drive.measure(kP1960);
  ASSERT_NE(drive.fault(7985), nullptr);
  EXPECT_EQ(drive.fault(7985)->value, value);
  drive.run_until([](const Axis& axis) { return axis.actual().state == State::Fault; }, 30.0);
  EXPECT_EQ(drive.state(), State::Fault);
  EXPECT_EQ(drive.shown(kP1960), 0.0);
  EXPECT_EQ(drive.shown(1969), 0.0);
  EXPECT_FALSE(drive.has(7980));
  EXPECT_EQ(drive.parameters(), before);
}

motor::Load locked_load() {
  motor::Load load{};
  load.coulomb_friction = 1000.0;
  return load;
}

TEST(IdentificationFailure, IsSeenWithALockedShaft) {
  MeasuringAxis still{real_axis("1fk7063", {}, locked_load())};
  expect_standstill_fault(still, StandstillFault::PolePosition);

  for (const char* const motor : {"1fk7063", "1le1003-2k2"}) {
    MeasuringAxis turning{real_axis(motor, {}, locked_load())};
    expect_rotating_fault(turning, step::kEncoderTest);
  }
}

TEST(IdentificationFailure, IsSeenWithALoadThatTurnsTheMotor) {
  for (const char* const motor : {"1fk7063", "1le1003-2k2"}) {
    MeasuringAxis drive{real_axis(motor)};
    drive.axis.set_load_torque(5.0);
    drive.on();
    drive.send(0x0006), drive.run(1.0);
    drive.axis.set_load_torque(-5.0);
    expect_standstill_fault(drive, StandstillFault::ShaftTurns);
  }
}

TEST(IdentificationFailure, IsSeenWithAReversedEncoder) {
  MeasuringAxis drive{real_axis("1fk7063")};
  drive.axis.fail_encoder(motor::EncoderDefect::Reversed);
  expect_standstill_fault(drive, StandstillFault::PolePosition);
}

TEST(IdentificationFailure, IsSeenWithAWrongPolePairNumber) {
  for (const double pairs : {1.0, 3.0}) {
    MeasuringAxis drive{real_axis("1le1003-2k2")};
    ASSERT_TRUE(drive.axis.write(10, 3.0));
    ASSERT_TRUE(drive.axis.write(314, pairs));
    ASSERT_TRUE(drive.axis.write(10, 0.0));
    const std::vector<double> before = drive.parameters();
    drive.measure(kP1960);
    EXPECT_FALSE(drive.axis.messages().faults().empty()) << pairs;
    ASSERT_NE(drive.fault(7985), nullptr) << pairs;
    EXPECT_EQ(drive.fault(7985)->value, step::kEncoderTest) << pairs;
    EXPECT_EQ(drive.parameters(), before);
  }
}

TEST(IdentificationFailure, IsSeenWithADataSheetOfAnotherMachine) {
  AxisConfiguration configuration = real_axis("1fk7063");
  configuration.deviation.stator_resistance = 200.0;
  MeasuringAxis drive{configuration};
  const std::vector<double> before = drive.parameters();
  drive.measure(kP1910);
  ASSERT_NE(drive.fault(7990), nullptr);
  EXPECT_EQ(drive.parameters(), before);
}

TEST(IdentificationFailure, IsAlsoAnEndWhereTheFaultHasNoReaction) {
  MeasuringAxis drive{real_axis("1fk7063", {}, locked_load())};
  ASSERT_TRUE(drive.axis.write(2100, 7990.0));
  ASSERT_TRUE(drive.axis.write(2101, 0.0));
  const std::vector<double> before = drive.parameters();
  drive.measure(kP1910);
  EXPECT_EQ(drive.state(), State::SwitchOnDisabled);
  EXPECT_NE(drive.fault(7990), nullptr);
  EXPECT_EQ(drive.shown(kP1910), 0.0);
  EXPECT_EQ(drive.parameters(), before);
}

TEST(IdentificationFailure, CanBeAcknowledgedAndTriedAgain) {
  MeasuringAxis drive{real_axis("1fk7063", kOther)};
  drive.axis.set_load_torque(3.0);
  drive.measure(kP1910);
  ASSERT_NE(drive.fault(7990), nullptr);
  drive.axis.set_load_torque(0.0);
  drive.send(0x0006), drive.run(5.0);
  drive.send(0x0086), drive.send(0x0006);
  EXPECT_TRUE(drive.axis.messages().faults().empty());

  drive.measure(kP1910);

  EXPECT_TRUE(drive.axis.messages().faults().empty());
  EXPECT_NEAR(drive.shown(350), 1.2 * 0.55, 0.02 * 0.66);
}

/// Both measurements on random machines: what the control believes in the end, within the tolerances of the unit.
TEST(IdentificationAccuracy, HoldsForRandomMachinesOfEveryPreset) {
  constexpr int kPlants = 6;
  std::mt19937_64 random{identification::plant_seed()};
  std::uniform_real_distribution<double> load_share{0.0, 5.0};
  for (const identification::Preset& preset : identification::presets()) {
    double worst[5]{};
    for (int plant = 0; plant < kPlants; ++plant) {
      const motor::PlantDeviation deviation = identification::random_deviation(random);
      const motor::Load load{.inertia = load_share(random) * preset.machine.inertia};
      MeasuringAxis drive{real_axis(preset.name, deviation, load)};
      const motor::MachineData real = motor::real_machine(preset.machine, deviation);
      drive.measure(kP1910);
      drive.measure(kP1960);
      ASSERT_TRUE(drive.axis.messages().faults().empty()) << preset.name << ", plant " << plant;
      const motor::MachineData believed =
          believed_machine(drive.axis.block<MotorModel>().settings, preset.machine);
      const auto note = [&](std::size_t quantity, double found, double truth) {
        worst[quantity] = std::max(worst[quantity], std::abs(found / truth - 1.0));
      };
      note(0, believed.stator_resistance, real.stator_resistance);
      note(3, drive.shown(341) * drive.shown(342), real.inertia + load.inertia);
      if (real.type == motor::MachineType::Synchronous) {
        note(1, believed.synchronous.d_inductance, real.synchronous.d_inductance);
        note(1, believed.synchronous.q_inductance, real.synchronous.q_inductance);
        note(4, believed.synchronous.magnet_flux, real.synchronous.magnet_flux);
      } else {
        const motor::InductionCircuit found = motor::induction_circuit(believed);
        const motor::InductionCircuit truth = motor::induction_circuit(real);
        note(1, found.leakage, truth.leakage);
        note(2, found.rotor_resistance, truth.rotor_resistance);
        note(2, found.magnetising_inductance, truth.magnetising_inductance);
        const double current = std::sqrt(2.0) * real.induction.magnetising_current;
        note(4, motor::standing_flux(found, current), motor::standing_flux(truth, current));
      }
    }
    std::cout << preset.name << ": R_s " << 100 * worst[0] << " %, L " << 100 * worst[1] << " %, R_R and L_M "
              << 100 * worst[2] << " %, J " << 100 * worst[3] << " %, flux " << 100 * worst[4] << " %\n";
    EXPECT_LT(worst[0], 0.02) << preset.name;
    EXPECT_LT(worst[1], 0.03) << preset.name;
    EXPECT_LT(worst[2], 0.05) << preset.name;
    EXPECT_LT(worst[3], 0.02) << preset.name;
    EXPECT_LT(worst[4], 0.02) << preset.name;
  }
}

}  // namespace
}  // namespace drive
