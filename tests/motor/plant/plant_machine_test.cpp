#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "motor/data/control_period.hpp"
#include "motor/plant/machine/synchronous_machine.hpp"
#include "tests/motor/reference/plant_runner.hpp"

namespace motor {
namespace {

MachineData induction_machine() {
  return {.type = MachineType::Induction, .pole_pairs = 2, .stator_resistance = 2.14, .inertia = 0.014};
}

TEST(PlantMachine, TorqueFollowsTheTorqueConstantUpToTheStallCurrentAndFallsShortAtTheMaximum) {
  MachineData data{};
  data.synchronous.torque_saturation = 0.1;
  SynchronousMachine machine{data};
  const double constant = 1.5 * 4.0 * data.synchronous.magnet_flux * std::numbers::sqrt2;  // N·m/A rms
  const auto torque = [&](double rms) {
    machine.set_state({Pair{0.0, rms * std::numbers::sqrt2}});
    return machine.torque();
  };

  EXPECT_NEAR(torque(5.0), 5.0 * constant, 1e-9);
  EXPECT_NEAR(torque(28.0), 0.9 * 28.0 * constant, 1e-9);
  EXPECT_NEAR(torque(-28.0), -torque(28.0), 1e-9);
  EXPECT_GT(torque(56.0), torque(28.0));
}

TEST(PlantMachine, AHotMachineHasLessTorqueAndMoreResistance) {
  MachineData data{};
  SynchronousMachine machine{data};
  machine.set_state({Pair{0.0, 5.0}});
  const double cold = machine.torque();

  machine.set_temperatures(120.0, 90.0);

  EXPECT_NEAR(machine.torque() / cold, 1.0 - 0.0010 * 70.0, 1e-12);
  const double losses = machine.losses({Pair{}, Pair{}, Pair{0.0, 25.0}, 0.0}, 1.0);
  EXPECT_NEAR(losses, 1.5 * 0.55 * (1.0 + 0.00393 * 100.0) * 25.0, 1e-9);
}

TEST(PlantMachine, CurrentsDieWithinMillisecondsOfAPulseInhibitAndGiveTheirEnergyBack) {
  PlantRunner runner{MachineData{}, {.inertia = 0.003}};
  runner.run(200.0, 0.02);
  ASSERT_GT(length(runner.state().current), 10.0);
  const double used = runner.used().electrical;

  runner.coast(560.0, 2e-3);

  EXPECT_EQ(length(runner.state().current), 0.0);
  EXPECT_LT(runner.used().electrical, used);
  EXPECT_NEAR(runner.missing() / runner.taken(), 0.0, 1e-4);
  runner.coast(560.0, 0.1);
  EXPECT_EQ(runner.state().torque, 0.0);
}

TEST(PlantMachine, FeedsTheLinkWhileItInducesMoreThanTheLinkHas) {
  const MachineData data{.coulomb_friction = 0.0, .viscous_friction = 0.0};
  PlantRunner runner{data, {.inertia = 0.01}};
  const double critical = 560.0 / std::numbers::sqrt3 / (data.pole_pairs * data.synchronous.magnet_flux);
  runner.plant().set_speed(1.5 * critical);

  runner.coast(560.0, 0.01);
  EXPECT_LT(runner.state().torque, -1.0);
  EXPECT_LT(runner.used().electrical, 0.0);
  runner.coast(560.0, 5.0);

  EXPECT_LE(runner.state().speed, critical);
  EXPECT_GT(runner.state().speed, 0.97 * critical);
  EXPECT_EQ(runner.state().torque, 0.0);
}

TEST(PlantMachine, AnInductionMachineLosesItsFluxAfterThePulses) {
  PlantRunner runner{induction_machine(), {}};
  runner.run(100.0, 1.0);
  const double flux = runner.state().flux;
  ASSERT_GT(flux, 0.7);

  runner.coast(560.0, 0.01);
  EXPECT_EQ(length(runner.state().current), 0.0);
  const double faded = runner.state().flux;
  runner.coast(560.0, 0.1);

  const double rotor_time_constant = (294.4e-3 + 12.31e-3) / 1.78;
  EXPECT_GT(faded, 0.9 * flux);
  EXPECT_NEAR(runner.state().flux / faded, std::exp(-0.1 / rotor_time_constant), 1e-4);
  EXPECT_FALSE(runner.plant().rests());
  runner.plant().set_speed(0.0);
  runner.coast(560.0, 10.0);
  EXPECT_TRUE(runner.plant().rests());
}

TEST(PlantMachine, SaturationHalvesTheMagnetisingInductanceAtItsFlux) {
  MachineData data = induction_machine();
  data.induction.saturation_flux = 1.0;
  data.induction.rotor_leakage = 0.0;
  Plant plant{data, {}};
  for (int i = 0; i < 80000; ++i) plant.step({data.stator_resistance * 2.0 / 294.4e-3, 0.0});

  EXPECT_NEAR(plant.state().flux, 1.0, 1e-6);
  EXPECT_NEAR(plant.state().current.re, 2.0 / 294.4e-3, 1e-4);
}

TEST(PlantMachine, AJammedRotorDrawsOnlyWhatItsResistanceLets) {
  Plant plant{MachineData{}, {.brake = {.torque = 1e4}}};

  for (int i = 0; i < 8000; ++i) plant.step({0.0, 10.0});

  EXPECT_EQ(plant.state().speed, 0.0);
  EXPECT_NEAR(plant.state().current.im, 10.0 / 0.55, 1e-6);
}

}  // namespace
}  // namespace motor
