/// What the motor identification of an axis finds, against the machine that turns.
#include <numbers>

#include "drive/machine/machine_model.hpp"
#include "motor/control/field/induction_circuit.hpp"
#include "tests/drive/measuring_axis.hpp"

namespace drive {
namespace {

TEST(StandstillIdentification, FindsTheDataOfASynchronousMachine) {
  const AxisConfiguration configuration = real_axis("1fk7063", kOther);
  MeasuringAxis drive{configuration};
  const motor::MachineData real = motor::real_machine(configuration.machine, kOther);
  ASSERT_NEAR(drive.shown(350), real.stator_resistance / 1.2, 1e-6) << "believes the data sheet";
  drive.setpoints.speed = 1000.0 * kRpm;  // is ignored
  double fastest = 0.0;

  ASSERT_TRUE(drive.axis.write(kP1910, 1.0));
  drive.on();
  const std::int64_t start = drive.axis.actual().encoder_counts;
  std::int64_t furthest = 0;
  while (drive.state() == State::OperationEnabled) {
    EXPECT_EQ(drive.shown(2), 14.0);
    EXPECT_GT(drive.shown(47), 0.0);
    drive.send(0x000F);
    fastest = std::max(fastest, std::abs(drive.rpm()));
    furthest = std::max(furthest, std::abs(drive.axis.actual().encoder_counts - start));
  }

  EXPECT_EQ(drive.state(), State::SwitchOnDisabled);
  EXPECT_EQ(drive.shown(2), 41.0) << "ON is still set";
  EXPECT_EQ(drive.shown(kP1910), 0.0);
  EXPECT_FALSE(drive.has(7991));
  EXPECT_TRUE(drive.axis.messages().faults().empty());
  EXPECT_LT(static_cast<double>(furthest) / motor::increments_per_revolution(configuration.machine), 30.0 / 360.0);
  EXPECT_LT(fastest, 100.0);
  EXPECT_NEAR(drive.shown(350), real.stator_resistance, 0.02 * real.stator_resistance);
  EXPECT_NEAR(drive.shown(357), 1e3 * real.synchronous.d_inductance, 30.0 * real.synchronous.d_inductance);
  EXPECT_NEAR(drive.shown(356), 1e3 * real.synchronous.q_inductance, 30.0 * real.synchronous.q_inductance);
  EXPECT_NEAR(drive.shown(1984), 0.0, 5.0);
  EXPECT_NEAR(drive.shown(1912), drive.shown(350), 1e-6);
  EXPECT_NEAR(drive.shown(1932), drive.shown(357), 1e-6);
  EXPECT_NEAR(drive.shown(1934), drive.shown(356), 1e-6);
  EXPECT_GT(drive.shown(1925), 1.0);
  EXPECT_EQ(
      drive.axis.drive_train().settings().current.q_proportional,
      motor::computed_settings(believed_machine(drive.axis.block<MotorModel>().settings, configuration.machine),
                               configuration.inverter, 1.0)
          .current.q_proportional)
      << "the current controllers know it";

  drive.turn_at(1000.0);
  EXPECT_NEAR(drive.rpm(), 1000.0, 1.0);
}

TEST(StandstillIdentification, FindsTheDataOfAnInductionMachineInEveryMode) {
  for (const double mode : {0.0, 20.0, 21.0, 22.0, 23.0}) {
    SCOPED_TRACE(mode);
    const AxisConfiguration configuration = real_axis("1le1003-2k2", kOther);
    MeasuringAxis drive{configuration};
    ASSERT_TRUE(drive.axis.write(1300, mode));
    drive.setpoints.speed = 500.0 * kRpm;
    drive.setpoints.torque = 5.0;
    const motor::MachineData real = motor::real_machine(configuration.machine, kOther);
    const motor::InductionCircuit circuit = motor::induction_circuit(real);

    drive.measure(kP1910);

    EXPECT_EQ(drive.state(), State::SwitchOnDisabled);
    const motor::InductionCircuit believed =
        motor::induction_circuit(believed_machine(drive.axis.block<MotorModel>().settings, configuration.machine));
    EXPECT_NEAR(believed.stator_resistance, circuit.stator_resistance, 0.02 * circuit.stator_resistance);
    EXPECT_NEAR(believed.rotor_resistance, circuit.rotor_resistance, 0.05 * circuit.rotor_resistance);
    EXPECT_NEAR(believed.leakage, circuit.leakage, 0.03 * circuit.leakage);
    EXPECT_NEAR(believed.magnetising_inductance, circuit.magnetising_inductance,
                0.05 * circuit.magnetising_inductance);
    EXPECT_NEAR(drive.shown(1913), drive.shown(1936) / drive.shown(1927), 1e-3 * drive.shown(1913));
    EXPECT_NEAR(drive.shown(1914), 1e3 * believed.leakage, 1e-3 * drive.shown(1914));
  }
}

TEST(StandstillIdentification, LeavesTheParametersAloneWhereItIsToldTo) {
  MeasuringAxis drive{real_axis("1fk7063", kOther)};
  const std::vector<double> before = drive.parameters();

  drive.measure(kP1910, -1.0);

  EXPECT_EQ(drive.parameters(), before);
  EXPECT_GT(drive.shown(1912), 1.1 * drive.shown(350));
  EXPECT_EQ(drive.shown(kP1910), 0.0);

  ASSERT_TRUE(drive.axis.write(kP1910, -3.0));
  EXPECT_NEAR(drive.shown(350), drive.shown(1912), 1e-6);
  EXPECT_EQ(drive.shown(kP1910), 0.0);
}

TEST(RotatingIdentification, FindsFluxInertiaAndControllersOfASynchronousMachine) {
  const motor::MachineData& data_sheet = identification::preset("1fk7063");
  const motor::Load load{.inertia = 5.0 * data_sheet.inertia};
  MeasuringAxis drive{real_axis("1fk7063", kOther, load)};
  ASSERT_TRUE(drive.axis.write(342, 1.0));
  ASSERT_TRUE(drive.axis.write(340, 4.0));
  const double gain = drive.shown(1460);
  const double inertia = 1.2 * data_sheet.inertia + load.inertia;
  drive.measure(kP1910);
  double fastest = 0.0;

  ASSERT_TRUE(drive.axis.write(kP1960, 1.0));
  drive.setpoints.speed = -7000.0 * kRpm;
  drive.on();
  while (drive.state() == State::OperationEnabled) {
    EXPECT_EQ(drive.shown(2), 14.0);
    drive.send(0x000F);
    fastest = std::max(fastest, std::abs(drive.rpm()));
  }

  EXPECT_EQ(drive.state(), State::SwitchOnDisabled);
  EXPECT_EQ(drive.shown(kP1960), 0.0);
  EXPECT_FALSE(drive.has(7980));
  EXPECT_GT(fastest, 500.0);
  EXPECT_LT(fastest, drive.shown(1082));
  EXPECT_NEAR(drive.shown(1969), inertia, 0.02 * inertia);
  EXPECT_NEAR(drive.shown(341) * drive.shown(342), inertia, 0.02 * inertia);
  EXPECT_NEAR(drive.shown(316), 0.9 * data_sheet.torque_constant, 0.01 * data_sheet.torque_constant);
  EXPECT_NEAR(drive.shown(1937), drive.shown(316), 1e-5);
  EXPECT_NEAR(drive.shown(1460) / gain, inertia / data_sheet.inertia, 0.03 * inertia / data_sheet.inertia);
  EXPECT_EQ(drive.shown(1496), 100.0) << "%, of the inertia that is known now";
}

TEST(RotatingIdentification, MakesTheSpeedControllerAsFastAsItIsToldTo) {
  MeasuringAxis drive{real_axis("1fk7063")};
  ASSERT_TRUE(drive.axis.write(1967, 200.0));
  ASSERT_TRUE(drive.axis.write(kP1960, -1.0));
  drive.on();
  drive.wait();
  EXPECT_EQ(drive.shown(1496), 0.0) << "for r19xx only";
  ASSERT_TRUE(drive.axis.write(kP1960, -3.0));
  const double gain = drive.shown(1460), time = drive.shown(1462);
  ASSERT_TRUE(drive.axis.write(340, 4.0));
  EXPECT_NEAR(gain, 2.0 * drive.shown(1460), 1e-3 * gain);
  EXPECT_NEAR(time, 0.5 * drive.shown(1462), 1e-3 * time);
}

TEST(StandstillIdentification, FindsTheSaturationOfAnInductionMachine) {
  for (const char* const motor : {"1le1003-2k2", "1ph8131", "im-2k2"}) {
    SCOPED_TRACE(motor);
    const AxisConfiguration configuration = real_axis(motor, kOther);
    MeasuringAxis drive{configuration};
    const motor::InductionCircuit real =
        motor::induction_circuit(motor::real_machine(configuration.machine, kOther));
    const double rated = std::numbers::sqrt2 * configuration.machine.induction.magnetising_current;
    drive.measure(kP1910);
    const double resistance = drive.shown(350);

    drive.measure(kP1910, 3.0);

    ASSERT_EQ(drive.state(), State::SwitchOnDisabled);
    EXPECT_TRUE(drive.axis.messages().faults().empty());
    EXPECT_EQ(drive.shown(kP1910), 0.0);
    EXPECT_EQ(drive.shown(350), resistance) << "the characteristic alone";
    const motor::InductionCircuit believed =
        motor::induction_circuit(believed_machine(drive.axis.block<MotorModel>().settings, configuration.machine));
    for (const double share : {0.3, 0.6, 1.0, 1.3}) {
      const double flux = motor::standing_flux(real, share * rated);
      EXPECT_NEAR(motor::standing_flux(believed, share * rated), flux, 0.05 * flux) << share;
    }
    for (std::uint16_t number = 362; number < 365; ++number) {
      EXPECT_LT(drive.shown(number), drive.shown(static_cast<std::uint16_t>(number + 1)));
      EXPECT_LT(drive.shown(static_cast<std::uint16_t>(number + 4)),
                drive.shown(static_cast<std::uint16_t>(number + 5)));
    }
  }
}

TEST(RotatingIdentification, FindsTheSaturationOfAnInductionMachine) {
  const AxisConfiguration configuration = real_axis("1ph8131", kOther);
  MeasuringAxis drive{configuration};
  const motor::MachineData real = motor::real_machine(configuration.machine, kOther);
  drive.measure(kP1910);

  drive.measure(kP1960);

  ASSERT_EQ(drive.state(), State::SwitchOnDisabled);
  const auto flux = [&](const motor::MachineData& machine, double share) {
    return motor::standing_flux(motor::induction_circuit(machine),
                                share * std::numbers::sqrt2 * real.induction.magnetising_current);
  };
  const motor::MachineData believed =
      believed_machine(drive.axis.block<MotorModel>().settings, configuration.machine);
  for (const double share : {0.5, 1.0, 1.3})
    EXPECT_NEAR(flux(believed, share), flux(real, share), 0.02 * flux(real, share)) << share;
  for (std::uint16_t i = 0; i < 4; ++i) {
    const double current = drive.shown(static_cast<std::uint16_t>(366 + i)) / 100.0;
    const double expected = flux(real, current) / flux(real, 1.0);
    EXPECT_NEAR(drive.shown(static_cast<std::uint16_t>(362 + i)) / 100.0, expected, 0.02 * expected) << i;
  }
  EXPECT_NEAR(drive.shown(1969), real.inertia, 0.02 * real.inertia);
}

}  // namespace
}  // namespace drive
