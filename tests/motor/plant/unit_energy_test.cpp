/// Where the energy of a whole unit goes: line, infeed, DC link, chopper, inverter, machine, shaft and load.
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "motor/plant/dc_link.hpp"
#include "tests/motor/reference/controlled_machines.hpp"

namespace motor {
namespace {

/// Two axes of one machine on a DC link that its rectifier only feeds, and every joule that passes (J).
class Unit {
 public:
  explicit Unit(const MachineData& machine)
      : link_{{.capacitance = 1e-3, .chopper_resistance = 20.0}},
        trains_{make_train(machine, ControlMode::Encoder, elastic(machine)),
                make_train(machine, ControlMode::Encoder, {.constant_torque = 0.2 * machine.rated_torque})},
        start_{stored()} {
    command_.pulses_enabled = true;
    command_.limits = {machine.maximum_torque, -machine.maximum_torque};
  }
  /// Both axes at @p speed (rad/s) for @p seconds, the load of the second one at @p torque (N·m).
  void run(double speed, double torque, double seconds) {
    command_.speed_setpoint = speed;
    trains_[1].set_load_torque(torque);
    const auto steps = std::lround(seconds / kControlPeriod);
    for (long i = 0; i < steps; ++i) step();
  }
  /// What no place accounts for.
  double missing() const {
    const SupplyEnergies& supply = link_.energies();
    const double in = supply.from_line + supply.missing;
    const double out = supply.to_line + supply.infeed_losses + supply.chopper;
    return in - out - spent_ - (stored() - start_);
  }
  double from_line() const { return link_.energies().from_line; }
  double chopper() const { return link_.energies().chopper; }

 private:
  static Load elastic(const MachineData& machine) {
    return {.inertia = 3.0 * machine.inertia,
            .coulomb_friction = 0.02 * machine.rated_torque,
            .viscous_friction = 1e-4,
            .breakaway_torque = 0.03 * machine.rated_torque,
            .fan_coefficient = 0.1 * machine.rated_torque / (machine.rated_speed * machine.rated_speed),
            .coupling = {.stiffness = 400.0 * machine.inertia * 400.0, .damping = 10.0 * machine.inertia}};
  }
  void step() {
    double drawn = 0.0;
    for (DriveTrain& train : trains_) {
      drawn += train.step(link_.voltage(), command_);
      const PlantEnergies& went = train.energies();
      spent_ += went.copper + went.iron + went.friction + went.load + train.inverter_losses();
    }
    link_.step(kControlPeriod, drawn);
  }
  double stored() const {
    double sum = link_.stored();
    for (const DriveTrain& train : trains_) sum += train.stored().sum();
    return sum;
  }

  DcLink link_;
  std::array<DriveTrain, 2> trains_;
  DriveCommand command_{};
  double spent_ = 0.0;
  double start_;
};

struct UnitEnergy : testing::TestWithParam<NamedMachine> {};

TEST_P(UnitEnergy, IsAccountedForInStartLoadBrakingIntoTheChopperAndReversal) {
  const MachineData& machine = GetParam().data;
  Unit unit{machine};
  const double speed = 0.9 * machine.rated_speed;
  const double torque = 0.6 * machine.rated_torque;

  unit.run(0.0, 0.0, 0.3);  // magnetises
  unit.run(speed, 0.0, 0.8);
  unit.run(speed, torque, 0.5);
  unit.run(0.0, torque, 0.5);
  unit.run(-speed, torque, 1.0);  // a weight that is let down
  unit.run(0.0, 0.0, 0.5);

  EXPECT_GT(unit.chopper(), 0.0);
  EXPECT_LT(std::abs(unit.missing()), 1e-3 * unit.from_line()) << "of " << unit.from_line() << " J";
}

INSTANTIATE_TEST_SUITE_P(EveryMachine, UnitEnergy, testing::ValuesIn(machines()), name_of);

TEST(InverterDrops, AreAskedForByTheControlAndLostInTheInverter) {
  constexpr double kVoltage = 540.0;
  const DriveCommand command{.pulses_enabled = true, .speed_setpoint = 30.0 * kRpm, .limits = {20.0, -20.0}};
  const auto started = [&](const InverterData& inverter) {
    DriveTrain train{MachineData{}, {.constant_torque = 5.0}, inverter};
    for (int i = 0; i < 8000; ++i) static_cast<void>(train.step(kVoltage, command));
    return train;
  };
  DriveTrain with = started({.dead_time = 1.5e-6, .forward_voltage = 0.8});
  EXPECT_GT(with.signals().voltage, started({}).signals().voltage + 5.0);
  EXPECT_NEAR(with.signals().measured_speed, command.speed_setpoint, 0.05);

  const double before = with.stored().sum();
  double drawn = 0.0;
  double lost = 0.0;
  for (int i = 0; i < 800; ++i) {
    drawn += with.step(kVoltage, command);
    const PlantEnergies& went = with.energies();
    lost += went.copper + went.iron + went.friction + went.load + with.inverter_losses();
  }
  EXPECT_NEAR(drawn, lost + with.stored().sum() - before, 1e-3 * drawn);
}

}  // namespace
}  // namespace motor
