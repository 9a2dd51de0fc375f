#include "drive/machine/machine_model.hpp"

#include <algorithm>
#include <array>

#include "drive/machine/magnetising_characteristic.hpp"

namespace drive {
namespace {

using motor::MachineType;

/// Kinds of machines that a rule holds for.
enum class Of : std::uint8_t { Any, Synchronous, Induction };

/// A condition on motor data, and the parameter that is blamed for its breach.
struct PlausibilityRow {
  std::uint16_t number;
  Of machine;
  bool (*holds)(const MotorData& data) noexcept;
};

template <double MotorData::*Value>
bool is_positive(const MotorData& data) noexcept {
  return data.*Value > 0.0;
}

template <double MotorData::*Lower, double MotorData::*Upper>
bool are_in_order(const MotorData& data) noexcept {
  return data.*Lower <= data.*Upper;
}

using P = MotorData;
constexpr std::array kPlausibility{
    PlausibilityRow{304, Of::Any, is_positive<&P::rated_voltage>},
    PlausibilityRow{305, Of::Any, is_positive<&P::rated_current>},
    PlausibilityRow{305, Of::Any, are_in_order<&P::rated_current, &P::motor_maximum_current>},
    PlausibilityRow{307, Of::Any, is_positive<&P::rated_power>},
    PlausibilityRow{308, Of::Induction, is_positive<&P::power_factor>},
    PlausibilityRow{310, Of::Any, is_positive<&P::rated_frequency>},
    PlausibilityRow{311, Of::Any, is_positive<&P::rated_speed>},
    PlausibilityRow{311, Of::Any, are_in_order<&P::rated_speed, &P::motor_maximum_speed>},
    PlausibilityRow{316, Of::Synchronous, is_positive<&P::torque_constant>},
    PlausibilityRow{320, Of::Induction, is_positive<&P::magnetising_current>},
    PlausibilityRow{341, Of::Any, is_positive<&P::motor_inertia>},
    PlausibilityRow{350, Of::Any, is_positive<&P::stator_resistance>},
    PlausibilityRow{354, Of::Induction, is_positive<&P::rotor_resistance>},
    PlausibilityRow{356, Of::Any, is_positive<&P::stator_leakage>},
    PlausibilityRow{357, Of::Synchronous, is_positive<&P::direct_inductance>},
    PlausibilityRow{358, Of::Induction, is_positive<&P::rotor_leakage>},
    PlausibilityRow{360, Of::Induction, is_positive<&P::main_inductance>},
};
constexpr std::uint16_t kMotorType = 300;

/// Values of p0300 from `first` to `last`.
struct MotorTypeRow {
  std::int32_t first;
  std::int32_t last;
  Of machine;
  bool is_listed;  ///< a series of motors, not a kind
};
constexpr std::array kMotorTypes{
    MotorTypeRow{1, 1, Of::Induction, false},
    MotorTypeRow{2, 2, Of::Synchronous, false},
    MotorTypeRow{10, 19, Of::Induction, true},
    MotorTypeRow{90, 199, Of::Induction, true},
    MotorTypeRow{200, 299, Of::Synchronous, true},
    MotorTypeRow{10000, 10100, Of::Any, true},  // its own plate, read
};

/// The row of p0300, or nullptr if no motor has it.
const MotorTypeRow* motor_type_row(std::int32_t number) noexcept {
  const auto* const row = std::ranges::find_if(
      kMotorTypes, [=](const MotorTypeRow& r) { return r.first <= number && number <= r.last; });
  return row != kMotorTypes.end() ? row : nullptr;
}

MagnetisingCharacteristic characteristic_of(const MotorData& p) noexcept {
  return {{p.characteristic_flux_1, p.characteristic_flux_2, p.characteristic_flux_3, p.characteristic_flux_4},
          {p.characteristic_current_1, p.characteristic_current_2, p.characteristic_current_3,
           p.characteristic_current_4}};
}

bool concerns(Of of, MachineType type) noexcept {
  return of == Of::Any || (of == Of::Induction) == (type == MachineType::Induction);
}

}  // namespace

motor::MachineData believed_machine(const MotorData& p, const motor::MachineData& machine) noexcept {
  motor::MachineData data = machine;
  data.rated_voltage = p.rated_voltage;
  data.rated_current = p.rated_current;
  data.rated_power = p.rated_power;
  data.power_factor = p.power_factor;
  data.rated_frequency = p.rated_frequency;
  data.rated_speed = p.rated_speed;
  data.maximum_speed = p.motor_maximum_speed;
  data.maximum_current = p.motor_maximum_current;
  data.inertia = p.motor_inertia;
  data.stator_resistance = p.stator_resistance;
  // What lies between power unit and motor is part of what the control sees of it.
  const double series = p.series_inductance;
  if (p.pole_pairs > 0) data.pole_pairs = static_cast<std::uint8_t>(p.pole_pairs);
  if (machine.type == MachineType::Induction) {
    data.induction.rotor_resistance = p.rotor_resistance;
    data.induction.stator_leakage = p.stator_leakage + series;
    data.induction.rotor_leakage = p.rotor_leakage;
    data.induction.magnetising_inductance = p.main_inductance;
    data.induction.magnetising_current = p.magnetising_current;
    data.induction.saturation_flux = saturation_flux(data, characteristic_of(p));
    return data;
  }
  // The data sheet's ratio of flux and torque constant is that of the machine.
  motor::SynchronousData& magnetic = data.synchronous;
  magnetic.d_inductance = p.direct_inductance + series;
  magnetic.q_inductance = p.stator_leakage + series;
  magnetic.magnet_flux *= p.torque_constant / machine.torque_constant;
  data.torque_constant = p.torque_constant;
  return data;
}

bool is_listed_motor(const MotorData& data) noexcept {
  const MotorTypeRow* const type = motor_type_row(data.motor_type);
  return (type != nullptr && type->is_listed) || data.motor_code != 0;
}

std::uint16_t implausible_motor_parameter(const MotorData& data, const motor::MachineData& machine) noexcept {
  const MotorTypeRow* const type = motor_type_row(data.motor_type);
  if (type == nullptr || !concerns(type->machine, machine.type)) return kMotorType;
  const auto* const broken = std::ranges::find_if(kPlausibility, [&](const PlausibilityRow& row) {
    return concerns(row.machine, machine.type) && !row.holds(data);
  });
  return broken != kPlausibility.end() ? broken->number : std::uint16_t{0};
}

}  // namespace drive
