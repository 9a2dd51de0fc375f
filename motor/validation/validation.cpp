#include "motor/validation/validation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "motor/plant/dc_link.hpp"
#include "motor/validation/validation_rule.hpp"

namespace motor {
namespace {

using namespace validation;  // NOLINT(google-build-using-namespace): its words are for these tables

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
    Rule<Load>{"friction_torque", kNotNegative<&Load::friction_torque>, kNotNegativeText},
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
    Rule<Supply>{"line_voltage",
                 [](const Supply& s) noexcept {
                   return s.line_voltage <= 0.0 ? s.line_voltage >= 0.0 : within(s.line_voltage, 70.0, 1000.0);
                 },
                 "0 or a number 70 to 1000"},
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
    Rule<Supply>{"line_voltage",
                 [](const Supply& s) noexcept { return kRectifierRatio * s.line_voltage < s.overvoltage; },
                 "a line whose rectified voltage, 1.35 times as high, is less than the overvoltage"},
    Rule<Supply>{
        "active_voltage",
        [](const Supply& s) noexcept { return s.infeed != Infeed::Active || s.active_voltage < s.overvoltage; },
        "less than the overvoltage"},
    Rule<Supply>{"undervoltage", kNotNegative<&Supply::undervoltage>, kNotNegativeText},
    Rule<Supply>{"undervoltage", [](const Supply& s) noexcept { return s.undervoltage < s.overvoltage; },
                 "less than the overvoltage"},
};

}  // namespace

std::optional<Impossible> find_impossible(const Load& load) noexcept {
  return first_broken<Load>(kLoadRules, load);
}

std::optional<Impossible> find_impossible(const MachineData& machine, const Load& load) noexcept {
  const bool rigid = load.coupling.stiffness <= 0.0;
  const double behind = rigid ? machine.inertia + load.inertia : load.inertia;
  const bool walls = std::isfinite(load.end_stops.lower) || std::isfinite(load.end_stops.upper);
  if (walls && !(load.end_stops.stiffness <= kFastestRate * kFastestRate * behind))
    return Impossible{"end_stops.stiffness", "a stiffness that resonates below 16 kHz"};
  if (walls && !(load.end_stops.damping <= kFastestRate * behind))
    return Impossible{"end_stops.damping", "a damping with a time constant above 10 us"};
  if (!(load.viscous_friction <= kFastestRate * behind))
    return Impossible{"viscous_friction", "a friction with a time constant above 10 us"};
  if (rigid) return std::nullopt;
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
