#include "tests/motor/reference/controlled_machines.hpp"

#include <ostream>

namespace motor {
namespace {

struct Plate {
  std::uint8_t pole_pairs;
  double rated_rpm;
  double maximum_rpm;
  double rated_frequency;
  double rated_voltage;
  double rated_current;
  double rated_torque;
  double rated_power;
  double maximum_current;
  double maximum_torque;
  double inertia;
};

MachineData with_plate(const Plate& plate) {
  MachineData machine;
  machine.pole_pairs = plate.pole_pairs;
  machine.rated_speed = plate.rated_rpm * kRpm;
  machine.maximum_speed = plate.maximum_rpm * kRpm;
  machine.rated_frequency = plate.rated_frequency;
  machine.rated_voltage = plate.rated_voltage;
  machine.rated_current = plate.rated_current;
  machine.stall_current = plate.rated_current;
  machine.rated_torque = plate.rated_torque;
  machine.rated_power = plate.rated_power;
  machine.maximum_current = plate.maximum_current;
  machine.maximum_torque = plate.maximum_torque;
  machine.inertia = plate.inertia;
  return machine;
}

MachineData synchronous(const Plate& plate, double stall_current, double resistance, const SynchronousData& data) {
  MachineData machine = with_plate(plate);
  machine.stall_current = stall_current;
  machine.stator_resistance = resistance;
  machine.synchronous = data;
  return machine;
}

MachineData induction(const Plate& plate, double power_factor, double resistance, const InductionData& data) {
  MachineData machine = with_plate(plate);
  machine.type = MachineType::Induction;
  machine.power_factor = power_factor;
  machine.torque_constant = 0.0;
  machine.stator_resistance = resistance;
  machine.induction = data;
  return machine;
}

}  // namespace

void PrintTo(const NamedMachine& machine, std::ostream* out) {  // NOLINT(readability-identifier-naming)
  *out << machine.name;
}

std::string name_of(const testing::TestParamInfo<NamedMachine>& info) {
  return std::string{info.param.name};
}

std::vector<NamedMachine> machines() {
  return {
      {"1ft7044", synchronous({3, 6000, 9000, 300, 340, 2.5, 2.0, 1257, 30, 23, 5.43e-4}, 5.7, 0.61,
                              {4.2e-3, 4.2e-3, 0.14814, 0.126, -0.001})},
      {"1fk7042", synchronous({4, 3000, 9000, 200, 330, 1.95, 2.6, 820, 8.3, 10.5, 2.9e-4}, 2.2, 3.9,
                              {17.5e-3, 17.5e-3, 0.17153, 0.0723, -0.001})},
      {"1fk7063", MachineData{}},
      {"salient", synchronous({3, 1500, 3000, 75, 370, 4.3, 14, 2200, 6.45, 21, 0.015}, 4.3, 3.6,
                              {0.036, 0.051, 0.545, 0.0, -0.001})},
      {"1le1003", induction({2, 1455, 4200, 50, 400, 4.55, 14.44, 2200, 9.1, 35, 0.014}, 0.81, 2.14,
                            {1.78, 12.31e-3, 12.31e-3, 0.2944, 2.4, 0.0})},
      {"1ph8131", induction({2, 1500, 8000, 51.3, 398, 24.5, 76.39, 12000, 50, 180, 0.109}, 0.81, 0.376,
                            {0.2813, 1.72e-3, 1.72e-3, 0.05146, 13.4, 0.0})},
      {"saturated", induction({2, 1436, 3000, 50, 400, 5, 14.6, 2200, 7.5, 22, 0.015}, 0.8, 3.7,
                              {2.297, 10.735e-3, 10.735e-3, 0.2343, 3.3, 1.3})},
  };
}

std::vector<NamedMachine> machines(MachineType type) {
  std::vector<NamedMachine> result;
  for (const NamedMachine& machine : machines())
    if (machine.data.type == type) result.push_back(machine);
  return result;
}

InverterData matching_inverter(const MachineData& machine) {
  return {.rated_current = 0.5 * machine.maximum_current, .maximum_current = machine.maximum_current};
}

DriveTrain make_train(const MachineData& machine, ControlMode mode, Load load) {
  load.inertia = load.inertia > 0.0 ? load.inertia : machine.inertia;
  DriveTrain train{machine, load, matching_inverter(machine)};
  ControlSettings settings = train.settings();
  settings.mode = mode;
  train.tune(settings);
  return train;
}

}  // namespace motor
