#include "motor/data/rating_plate.hpp"

#include <cmath>
#include <numbers>

#include "motor/math/crossing.hpp"
#include "motor/math/space_vector.hpp"

namespace motor {
namespace {

constexpr double kStatorShare = 0.37;    // of all losses at the rating point
constexpr double kBreakdownRatio = 3.6;  // breakdown torque over rated torque
// Of servo motors; between these numbers and the motors of motors/ lies less than a factor of 2.
constexpr double kResistiveShare = 0.12;  // of the reactance that lets the maximum current through
constexpr double kInertia = 1e-4;         // kg·m² at 1 N·m, growing with the torque to the power of 5/3

/// What the plate says, per phase.
struct Plate {
  double voltage;    // V rms
  double frequency;  // rad/s
  double slip;
  double torque;          // N·m
  double reactive_power;  // var
  double pole_pairs;
  double stator_resistance;  // Ω, from the losses
};

/// The T circuit with equal leakages.
struct Circuit {
  double rotor_resistance;
  double leakage;
  double magnetising;
};

SpaceVector inverse(SpaceVector z) noexcept {
  return (1.0 / norm(z)) * conjugate(z);
}

Plate read(const MachineData& machine) noexcept {
  const double voltage = machine.rated_voltage / std::numbers::sqrt3;
  const double frequency = 2.0 * std::numbers::pi * machine.rated_frequency;
  const double apparent = 3.0 * voltage * machine.rated_current;
  const double losses = apparent * machine.power_factor - machine.rated_power;
  return {.voltage = voltage,
          .frequency = frequency,
          .slip = 1.0 - machine.pole_pairs * machine.rated_speed / frequency,
          .torque = machine.rated_power / machine.rated_speed,
          .reactive_power = apparent * std::sqrt(1.0 - machine.power_factor * machine.power_factor),
          .pole_pairs = static_cast<double>(machine.pole_pairs),
          .stator_resistance = kStatorShare * losses / (3.0 * machine.rated_current * machine.rated_current)};
}

/// Torque and reactive power at the rating point.
struct Point {
  double torque;
  double reactive_power;
};
Point at_rating(const Plate& plate, const Circuit& circuit) noexcept {
  const double leakage = plate.frequency * circuit.leakage;
  const SpaceVector rotor{circuit.rotor_resistance / plate.slip, leakage};
  const SpaceVector main{0.0, plate.frequency * circuit.magnetising};
  const SpaceVector gap = inverse(inverse(rotor) + inverse(main));
  const SpaceVector current = plate.voltage * inverse(SpaceVector{plate.stator_resistance, leakage} + gap);
  const SpaceVector rotor_current = current * gap * inverse(rotor);
  return {3.0 * plate.pole_pairs / plate.frequency * norm(rotor_current) * rotor.re,
          -3.0 * plate.voltage * current.im};
}

/// Highest torque over all slips: the rotor on the source that stator and magnetising inductance make.
double breakdown(const Plate& plate, double leakage, double magnetising) noexcept {
  const double x = plate.frequency * leakage;
  const SpaceVector stator{plate.stator_resistance, x};
  const SpaceVector main{0.0, plate.frequency * magnetising};
  const SpaceVector share = main * inverse(stator + main);
  const SpaceVector source = stator * share;
  const double reactance = source.im + x;
  const double voltage = norm(share) * plate.voltage * plate.voltage;
  return 1.5 * plate.pole_pairs / plate.frequency * voltage / (source.re + std::hypot(source.re, reactance));
}

double rotor_resistance_for(const Plate& plate, double leakage, double magnetising) noexcept {
  const double least = 2.0 * plate.slip * plate.frequency * leakage;  // below: beyond the breakdown slip
  const double most =
      100.0 * plate.slip * plate.voltage * plate.voltage * plate.pole_pairs / (plate.frequency * plate.torque);
  return crossing(least, most, [&](double resistance) {
    return plate.torque - at_rating(plate, {resistance, leakage, magnetising}).torque;
  });
}

Circuit circuit_for(const Plate& plate, double magnetising) noexcept {
  const double base = plate.voltage * plate.voltage * plate.pole_pairs / (plate.frequency * plate.torque);
  const double leakage = crossing(0.001 * base / plate.frequency, base / plate.frequency, [&](double value) {
    return kBreakdownRatio * plate.torque - breakdown(plate, value, magnetising);
  });
  return {rotor_resistance_for(plate, leakage, magnetising), leakage, magnetising};
}

}  // namespace

MachineData circuit_from_plate(const MachineData& machine) noexcept {
  const Plate plate = read(machine);
  const double base = plate.voltage * plate.voltage * plate.pole_pairs / (plate.frequency * plate.torque);
  const double magnetising =
      crossing(base / plate.frequency, 50.0 * base / plate.frequency, [&](double inductance) {
        return plate.reactive_power - at_rating(plate, circuit_for(plate, inductance)).reactive_power;
      });
  const Circuit circuit = circuit_for(plate, magnetising);
  MachineData result = machine;
  result.stator_resistance = plate.stator_resistance;
  result.induction.rotor_resistance = circuit.rotor_resistance;
  result.induction.stator_leakage = circuit.leakage;
  result.induction.rotor_leakage = circuit.leakage;
  result.induction.magnetising_inductance = magnetising;
  result.induction.magnetising_current =
      plate.voltage / std::hypot(plate.stator_resistance, plate.frequency * (circuit.leakage + magnetising));
  return result;
}

MachineData magnetic_data_from_plate(const MachineData& machine) noexcept {
  if (!(machine.rated_voltage > 0.0 && machine.rated_frequency > 0.0 && machine.maximum_current > 0.0))
    return machine;
  const double frequency = 2.0 * std::numbers::pi * machine.rated_frequency;
  const double reactance = machine.rated_voltage / (std::numbers::sqrt3 * machine.maximum_current);
  MachineData result = machine;
  result.stator_resistance = kResistiveShare * reactance;
  const double saliency = machine.synchronous.d_inductance / machine.synchronous.q_inductance;
  result.synchronous.q_inductance = reactance / frequency;
  result.synchronous.d_inductance = saliency * result.synchronous.q_inductance;
  return result;
}

double inertia_from_plate(const MachineData& machine) noexcept {
  if (!(machine.rated_power > 0.0 && machine.rated_speed > 0.0)) return machine.inertia;
  return kInertia * std::pow(machine.rated_power / machine.rated_speed, 5.0 / 3.0);
}

}  // namespace motor
