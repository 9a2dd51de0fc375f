#include "motor/validation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

namespace motor {
namespace {

/// A member and what it has to be.
template <class Data>
struct Rule {
  std::string_view member;
  bool (*holds)(const Data&) noexcept;
  std::string_view expected;
};

constexpr std::string_view kPositiveText = "a number above 0";
constexpr std::string_view kNotNegativeText = "a number not below 0";
constexpr std::string_view kNumberText = "a finite number";

constexpr double kSmallest = 1e-12;   // that counts as above 0, so that its reciprocal is harmless
constexpr double kFastestRate = 1e5;  // 1/s, of what the models integrate with sub-steps

bool positive(double value) noexcept {
  return std::isfinite(value) && value >= kSmallest;
}
bool not_negative(double value) noexcept {
  return std::isfinite(value) && value >= 0.0;
}
/// Written so that NaN is outside.
bool within(double value, double low, double high) noexcept {
  return value >= low && value <= high;
}

template <auto member>
constexpr auto kPositive = []<class Data>(const Data& data) noexcept { return positive(data.*member); };
template <auto member>
constexpr auto kNotNegative = []<class Data>(const Data& data) noexcept { return not_negative(data.*member); };
template <auto member>
constexpr auto kFinite = []<class Data>(const Data& data) noexcept { return std::isfinite(data.*member); };
/// The same for a member of a struct inside.
template <auto part, auto member>
constexpr auto kPositivePart = []<class Data>(const Data& data) noexcept { return positive(data.*part.*member); };
template <auto part, auto member>
constexpr auto kNotNegativePart =
    []<class Data>(const Data& data) noexcept { return not_negative(data.*part.*member); };

template <class Data>
std::optional<Impossible> first_broken(std::span<const Rule<Data>> rules, const Data& data) noexcept {
  for (const Rule<Data>& rule : rules)
    if (!rule.holds(data)) return Impossible{rule.member, rule.expected};
  return std::nullopt;
}

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

bool ascending(const TorqueProfile& profile) noexcept {
  const auto end = profile.points.begin() + static_cast<std::ptrdiff_t>(profile.count);
  const auto not_later = [](const TorqueProfile::Point& a, const TorqueProfile::Point& b) {
    return !(a.time < b.time);
  };
  return std::adjacent_find(profile.points.begin(), end, not_later) == end;
}
bool finite(const TorqueProfile& profile) noexcept {
  return std::all_of(profile.points.begin(), profile.points.begin() + static_cast<std::ptrdiff_t>(profile.count),
                     [](const auto& p) { return std::isfinite(p.torque) && not_negative(p.time); });
}
/// A profile that repeats has a length and begins at once.
bool has_period(const TorqueProfile& profile) noexcept {
  return !profile.repeats || (profile.count >= 2 && std::abs(profile.points[0].time) <= 0.0);
}

constexpr std::array kLoadRules{
    Rule<Load>{"inertia", kNotNegative<&Load::inertia>, kNotNegativeText},
    Rule<Load>{"coulomb_friction", kNotNegative<&Load::coulomb_friction>, kNotNegativeText},
    Rule<Load>{"viscous_friction", kNotNegative<&Load::viscous_friction>, kNotNegativeText},
    Rule<Load>{"breakaway_torque", kNotNegative<&Load::breakaway_torque>, kNotNegativeText},
    Rule<Load>{"stribeck_speed", kPositive<&Load::stribeck_speed>, kPositiveText},
    Rule<Load>{"constant_torque", kFinite<&Load::constant_torque>, kNumberText},
    Rule<Load>{"fan_coefficient", kNotNegative<&Load::fan_coefficient>, kNotNegativeText},
    Rule<Load>{"pendulum_torque", kFinite<&Load::pendulum_torque>, kNumberText},
    Rule<Load>{"profile", [](const Load& l) noexcept { return l.profile.count <= TorqueProfile::kCapacity; },
               "at most 64 points"},
    Rule<Load>{"profile", [](const Load& l) noexcept { return finite(l.profile); },
               "finite torques at times not below 0"},
    Rule<Load>{"profile", [](const Load& l) noexcept { return ascending(l.profile); }, "ascending times"},
    Rule<Load>{"profile", [](const Load& l) noexcept { return has_period(l.profile); },
               "two points or more, the first at time 0, to repeat"},
    Rule<Load>{"coupling.stiffness", kNotNegativePart<&Load::coupling, &Coupling::stiffness>, kNotNegativeText},
    Rule<Load>{"coupling.damping", kNotNegativePart<&Load::coupling, &Coupling::damping>, kNotNegativeText},
    Rule<Load>{"coupling.backlash", kNotNegativePart<&Load::coupling, &Coupling::backlash>, kNotNegativeText},
    Rule<Load>{"inertia",
               [](const Load& l) noexcept { return l.coupling.stiffness <= 0.0 || positive(l.inertia); },
               "a number above 0 behind a coupling"},
    Rule<Load>{"end_stops.lower", [](const Load& l) noexcept { return l.end_stops.lower <= 0.0; },
               "a number not above 0, where the load is at power-on"},
    Rule<Load>{"end_stops.upper", [](const Load& l) noexcept { return l.end_stops.upper >= 0.0; },
               "a number not below 0, where the load is at power-on"},
    Rule<Load>{"end_stops.stiffness", kPositivePart<&Load::end_stops, &EndStops::stiffness>, kPositiveText},
    Rule<Load>{"end_stops.damping", kNotNegativePart<&Load::end_stops, &EndStops::damping>, kNotNegativeText},
    Rule<Load>{"brake.torque", kNotNegativePart<&Load::brake, &HoldingBrake::torque>, kNotNegativeText},
    Rule<Load>{"brake.opening_time", kNotNegativePart<&Load::brake, &HoldingBrake::opening_time>,
               kNotNegativeText},
    Rule<Load>{"brake.closing_time", kNotNegativePart<&Load::brake, &HoldingBrake::closing_time>,
               kNotNegativeText},
};

using Inverter = InverterData;
constexpr std::array kInverterRules{
    Rule<Inverter>{"rated_current", kPositive<&Inverter::rated_current>, kPositiveText},
    Rule<Inverter>{"maximum_current", kPositive<&Inverter::maximum_current>, kPositiveText},
    Rule<Inverter>{"rated_current",
                   [](const Inverter& i) noexcept { return i.rated_current <= i.maximum_current; },
                   "not more than the maximum current"},
    Rule<Inverter>{
        "trip_current",
        [](const Inverter& i) noexcept { return i.trip_current > std::numbers::sqrt2 * i.maximum_current; },
        "more than the peak of the maximum current"},
    Rule<Inverter>{"dead_time", kNotNegative<&Inverter::dead_time>, kNotNegativeText},
    Rule<Inverter>{"forward_voltage", kNotNegative<&Inverter::forward_voltage>, kNotNegativeText},
    Rule<Inverter>{"pulse_frequency", kPositive<&Inverter::pulse_frequency>, kPositiveText},
    Rule<Inverter>{"idle_losses", kNotNegative<&Inverter::idle_losses>, kNotNegativeText},
    Rule<Inverter>{"losses_per_ampere", kNotNegative<&Inverter::losses_per_ampere>, kNotNegativeText},
    Rule<Inverter>{"losses_per_square", kNotNegative<&Inverter::losses_per_square>, kNotNegativeText},
    Rule<Inverter>{"overload_time_constant", kPositive<&Inverter::overload_time_constant>, kPositiveText},
    Rule<Inverter>{"chip_time_constant", kPositive<&Inverter::chip_time_constant>, kPositiveText},
    Rule<Inverter>{"chip_rise", kNotNegative<&Inverter::chip_rise>, kNotNegativeText},
    Rule<Inverter>{"heat_sink_time_constant", kPositive<&Inverter::heat_sink_time_constant>, kPositiveText},
    Rule<Inverter>{"heat_sink_rise", kNotNegative<&Inverter::heat_sink_rise>, kNotNegativeText},
    Rule<Inverter>{"ambient", [](const Inverter& i) noexcept { return within(i.ambient, -40.0, 100.0); },
                   "a number -40 to 100"},
};

using Supply = SupplyData;
constexpr std::array kSupplyRules{
    Rule<Supply>{"line_voltage", kNotNegative<&Supply::line_voltage>, kNotNegativeText},
    Rule<Supply>{"active_voltage", kPositive<&Supply::active_voltage>, kPositiveText},
    Rule<Supply>{"line_resistance", kPositive<&Supply::line_resistance>, kPositiveText},
    Rule<Supply>{"rated_power", kPositive<&Supply::rated_power>, kPositiveText},
    Rule<Supply>{"capacitance", kPositive<&Supply::capacitance>, kPositiveText},
    Rule<Supply>{"chopper_resistance", kNotNegative<&Supply::chopper_resistance>, kNotNegativeText},
    Rule<Supply>{"chopper_on", kPositive<&Supply::chopper_on>, kPositiveText},
    Rule<Supply>{"chopper_off",
                 [](const Supply& s) noexcept {
                   return within(s.chopper_off, 0.0, s.chopper_on) && s.chopper_off < s.chopper_on;
                 },
                 "less than the voltage at which the chopper goes on"},
    Rule<Supply>{"chopper_sampling",
                 [](const Supply& s) noexcept {
                   return s.chopper_sampling <= 0.0 ? s.chopper_sampling >= 0.0
                                                    : within(s.chopper_sampling, 2.5e-6, 1.0);
                 },
                 "0 or a number 2.5e-6 to 1"},
    Rule<Supply>{"overvoltage", kPositive<&Supply::overvoltage>, kPositiveText},
    Rule<Supply>{"undervoltage", kNotNegative<&Supply::undervoltage>, kNotNegativeText},
    Rule<Supply>{"undervoltage", [](const Supply& s) noexcept { return s.undervoltage < s.overvoltage; },
                 "less than the overvoltage"},
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

std::optional<Impossible> find_impossible(const Load& load) noexcept {
  return first_broken<Load>(kLoadRules, load);
}

std::optional<Impossible> find_impossible(const MachineData& machine, const Load& load) noexcept {
  if (load.coupling.stiffness <= 0.0) return std::nullopt;
  const double mobility = 1.0 / machine.inertia + 1.0 / load.inertia;
  if (!(load.coupling.stiffness * mobility <= kFastestRate * kFastestRate))
    return Impossible{"coupling.stiffness", "a stiffness that resonates below 16 kHz"};
  if (!(load.coupling.damping * mobility <= kFastestRate))
    return Impossible{"coupling.damping", "a damping with a time constant above 10 us"};
  return std::nullopt;
}

std::optional<Impossible> find_impossible(const InverterData& inverter) noexcept {
  return first_broken<InverterData>(kInverterRules, inverter);
}

std::optional<Impossible> find_impossible(const SupplyData& supply) noexcept {
  return first_broken<SupplyData>(kSupplyRules, supply);
}

}  // namespace motor
