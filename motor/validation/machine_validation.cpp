#include <algorithm>
#include <array>

#include "motor/validation/validation_rule.hpp"

namespace motor {
namespace {

using namespace validation;  // NOLINT(google-build-using-namespace): its words are for these tables

using Machine = MachineData;
using MachineRule = Rule<Machine>;
constexpr std::array kMachineRules{
    MachineRule{"pole_pairs", [](const Machine& m) noexcept { return m.pole_pairs >= 1; }, "an integer 1 to 255"},
    MachineRule{"rated_voltage", kPositive<&Machine::rated_voltage>, kPositiveText},
    MachineRule{"maximum_current", kPositive<&Machine::maximum_current>, kPositiveText},
    MachineRule{"rated_current", kPositive<&Machine::rated_current>, kPositiveText},
    MachineRule{"rated_current", [](const Machine& m) noexcept { return m.rated_current <= m.maximum_current; },
                "not more than the maximum current"},
    MachineRule{"rated_power", kPositive<&Machine::rated_power>, kPositiveText},
    MachineRule{"power_factor", [](const Machine& m) noexcept { return within(m.power_factor, 0.0, 1.0); },
                "a number 0 to 1"},
    MachineRule{"rated_frequency", kPositive<&Machine::rated_frequency>, kPositiveText},
    MachineRule{"maximum_speed", kPositive<&Machine::maximum_speed>, kPositiveText},
    MachineRule{"maximum_speed",
                [](const Machine& m) noexcept { return m.pole_pairs * m.maximum_speed <= kFastestRate; },
                "a speed with an electrical frequency below 16 kHz"},
    MachineRule{"rated_speed", kPositive<&Machine::rated_speed>, kPositiveText},
    MachineRule{"rated_speed", [](const Machine& m) noexcept { return m.rated_speed <= m.maximum_speed; },
                "not more than the maximum speed"},
    MachineRule{"maximum_torque", kPositive<&Machine::maximum_torque>, kPositiveText},
    MachineRule{"rated_torque", kPositive<&Machine::rated_torque>, kPositiveText},
    MachineRule{"rated_torque", [](const Machine& m) noexcept { return m.rated_torque <= m.maximum_torque; },
                "not more than the maximum torque"},
    MachineRule{"torque_constant", kNotNegative<&Machine::torque_constant>, kNotNegativeText},
    MachineRule{"stall_current", kPositive<&Machine::stall_current>, kPositiveText},
    MachineRule{"stall_current", [](const Machine& m) noexcept { return m.stall_current <= m.maximum_current; },
                "not more than the maximum current"},
    MachineRule{"stator_resistance", kPositive<&Machine::stator_resistance>, kPositiveText},
    MachineRule{"inertia", kPositive<&Machine::inertia>, kPositiveText},
    MachineRule{"coulomb_friction", kNotNegative<&Machine::coulomb_friction>, kNotNegativeText},
    MachineRule{"viscous_friction", kNotNegative<&Machine::viscous_friction>, kNotNegativeText},
    MachineRule{"hysteresis_torque", kNotNegative<&Machine::hysteresis_torque>, kNotNegativeText},
    MachineRule{"eddy_current_drag", kNotNegative<&Machine::eddy_current_drag>, kNotNegativeText},
};

using Magnets = SynchronousData;
constexpr std::array kSynchronousRules{
    Rule<Magnets>{"synchronous.d_inductance", kPositive<&Magnets::d_inductance>, kPositiveText},
    Rule<Magnets>{"synchronous.q_inductance", kPositive<&Magnets::q_inductance>, kPositiveText},
    Rule<Magnets>{"synchronous.magnet_flux", kPositive<&Magnets::magnet_flux>, kPositiveText},
    Rule<Magnets>{"synchronous.torque_saturation",
                  [](const Magnets& m) noexcept { return within(m.torque_saturation, 0.0, 0.5); },
                  "a number 0 to 0.5"},
    Rule<Magnets>{"synchronous.magnet_temperature_coefficient",
                  [](const Magnets& m) noexcept { return within(m.magnet_temperature_coefficient, -0.005, 0.0); },
                  "a number -0.005 to 0"},
};

using Cage = InductionData;
constexpr std::array kInductionRules{
    Rule<Cage>{"induction.rotor_resistance", kPositive<&Cage::rotor_resistance>, kPositiveText},
    Rule<Cage>{"induction.stator_leakage", kPositive<&Cage::stator_leakage>, kPositiveText},
    Rule<Cage>{"induction.rotor_leakage", kPositive<&Cage::rotor_leakage>, kPositiveText},
    Rule<Cage>{"induction.magnetising_inductance", kPositive<&Cage::magnetising_inductance>, kPositiveText},
    Rule<Cage>{"induction.magnetising_current", kPositive<&Cage::magnetising_current>, kPositiveText},
    Rule<Cage>{"induction.saturation_flux", kNotNegative<&Cage::saturation_flux>, kNotNegativeText},
};

using Thermal = ThermalData;
constexpr std::array kThermalRules{
    Rule<Thermal>{"thermal.winding_capacity", kPositive<&Thermal::winding_capacity>, kPositiveText},
    Rule<Thermal>{"thermal.frame_capacity", kPositive<&Thermal::frame_capacity>, kPositiveText},
    Rule<Thermal>{"thermal.winding_to_frame", kPositive<&Thermal::winding_to_frame>, kPositiveText},
    Rule<Thermal>{"thermal.frame_to_ambient", kPositive<&Thermal::frame_to_ambient>, kPositiveText},
    Rule<Thermal>{"thermal.ambient", [](const Thermal& t) noexcept { return within(t.ambient, -40.0, 100.0); },
                  "a number -40 to 100"},
};

constexpr std::uint32_t kMostPulses = 16'777'215;
constexpr std::uint32_t kMostRevolutions = 65'535;
bool fine_bits(std::uint8_t bits) noexcept {
  return bits >= 2 && bits <= 18;
}
constexpr std::array kEncoderRules{
    Rule<EncoderData>{"encoder.pulses",
                      [](const EncoderData& e) noexcept { return e.pulses >= 1 && e.pulses <= kMostPulses; },
                      "an integer 1 to 16777215"},
    Rule<EncoderData>{"encoder.fine_bits", [](const EncoderData& e) noexcept { return fine_bits(e.fine_bits); },
                      "an integer 2 to 18"},
    Rule<EncoderData>{
        "encoder.revolutions",
        [](const EncoderData& e) noexcept { return e.revolutions >= 1 && e.revolutions <= kMostRevolutions; },
        "an integer 1 to 65535"},
    Rule<EncoderData>{"encoder.absolute_fine_bits",
                      [](const EncoderData& e) noexcept { return fine_bits(e.absolute_fine_bits); },
                      "an integer 2 to 18"},
    Rule<EncoderData>{
        "encoder.start_position",
        [](const EncoderData& e) noexcept { return within(e.start_position, 0.0, kMostRevolutions); },
        "a number 0 to 65535"},
};

/// Whether the currents of @p machine change slowly enough.
bool can_be_integrated(const Machine& machine) noexcept {
  const bool magnets = machine.type == MachineType::Synchronous;
  const double inductance = magnets ? std::min(machine.synchronous.d_inductance, machine.synchronous.q_inductance)
                                    : machine.induction.stator_leakage;
  return machine.stator_resistance <= kFastestRate * inductance;
}

/// The first of two answers that says something.
std::optional<Impossible> either(std::optional<Impossible> first, std::optional<Impossible> second) noexcept {
  return first ? first : second;
}

}  // namespace

std::optional<Impossible> find_impossible(const MachineData& machine) noexcept {
  const auto type = machine.type == MachineType::Synchronous
                        ? first_broken<SynchronousData>(kSynchronousRules, machine.synchronous)
                        : first_broken<InductionData>(kInductionRules, machine.induction);
  const auto rest = either(first_broken<ThermalData>(kThermalRules, machine.thermal),
                           first_broken<EncoderData>(kEncoderRules, machine.encoder));
  const auto broken = either(first_broken<MachineData>(kMachineRules, machine), either(type, rest));
  if (broken || can_be_integrated(machine)) return broken;
  return Impossible{"stator_resistance", "a resistance with an electrical time constant above 10 us"};
}

}  // namespace motor
