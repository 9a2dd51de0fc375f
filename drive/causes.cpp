#include "drive/causes.hpp"

#include <algorithm>
#include <cmath>

#include "drive/speed_monitors.hpp"

namespace drive {
namespace {

using O = Observed;
using L = CauseLimits;

constexpr double kNone = 0.0;
constexpr double kAtOnce = 0.0;  // s
constexpr double kYes = 0.5;     // between 0 and 1

// clang-format off
constexpr std::array kCauses{
    CauseRow{7011, &O::motor_temperature, Side::Above, &L::temperature_fault, 2.0, kAtOnce, Pulses::Any, &O::motor_temperature, 10.0, "p0605"},
    CauseRow{7011, &O::motor_temperature, Side::Above, &L::temperature_alarm, 2.0, 240.0, Pulses::Any, &O::motor_temperature, 10.0, "p0604 for longer than p0606, whose factory value is 240 s"},
    CauseRow{7012, &O::motor_utilisation, Side::Above, 1.1, 0.02, kAtOnce, Pulses::Any, nullptr, kNone, "I2t model at 110 %, the factory value of p5390"},
    CauseRow{7090, &O::crossed_torque_limits, Side::Above, kNone, kNone, kAtOnce, Pulses::Any, nullptr, kNone, "p1520 below p1521"},
    CauseRow{7805, &O::overload, Side::Above, 0.95, 0.02, kAtOnce, Pulses::Any, &O::overload, 16384.0, "r0036 at 95 %, the factory value of p0294"},
    CauseRow{7900, &O::stuck, Side::Above, kYes, kNone, &L::blocked_delay, Pulses::On, nullptr, kNone, "p2175, p2177"},
    CauseRow{7901, &O::overspeed, Side::Above, &L::overspeed_hysteresis, kNone, kAtOnce, Pulses::Any, nullptr, kNone, "p1082, p1083, p1086, p0322 with p2162"},
    CauseRow{7910, &O::motor_temperature, Side::Above, &L::temperature_alarm, 2.0, kAtOnce, Pulses::Any, &O::motor_temperature, 10.0, "p0604"},
    CauseRow{7950, &O::implausible_parameter, Side::Above, kYes, kNone, kAtOnce, Pulses::Any, &O::implausible_parameter, 1.0, "motor data"},
    CauseRow{30001, &O::peak_current, Side::Above, &L::trip_current, kNone, kAtOnce, Pulses::Any, &O::overcurrent_phases, 1.0, "trip current of the power unit"},
    CauseRow{30002, &O::dc_voltage, Side::Above, &L::overvoltage, kNone, kAtOnce, Pulses::On, &O::dc_voltage, 10.0, "trip voltage of the power unit"},
    CauseRow{30003, &O::lowest_dc_voltage, Side::Below, &L::undervoltage, kNone, kAtOnce, Pulses::On, &O::lowest_dc_voltage, 10.0, "trip voltage of the power unit"},
    CauseRow{30004, &O::heat_sink, Side::Above, 95.0, 5.0, kAtOnce, Pulses::Any, &O::heat_sink, 100.0, "heat sink, plausible"},
    CauseRow{30005, &O::overload, Side::Above, 1.0, 0.05, kAtOnce, Pulses::Any, &O::overload, 16384.0, "r0036 at 100 %"},
    CauseRow{30016, &O::lowest_dc_voltage, Side::Below, &L::undervoltage, 10.0, kAtOnce, Pulses::Off, &O::lowest_dc_voltage, 1.0, "trip voltage of the power unit"},
    CauseRow{30025, &O::chip_rise, Side::Above, 95.0, 5.0, kAtOnce, Pulses::Any, &O::chip_rise, 100.0, "chip above heat sink, plausible"},
    CauseRow{30502, &O::dc_voltage, Side::Above, &L::overvoltage, 10.0, kAtOnce, Pulses::Off, &O::dc_voltage, 1.0, "trip voltage of the power unit"},
    CauseRow{31100, &O::zero_mark_deviation, Side::Above, kYes, kNone, kAtOnce, Pulses::Any, &O::zero_mark_deviation, 1.0, "increments between two zero marks"},
    CauseRow{31116, &O::encoder_lost, Side::Above, kYes, kNone, kAtOnce, Pulses::Any, nullptr, kNone, "encoder without signals"},
};
// clang-format on
static_assert(kCauses.size() <= kMostCauses);
static_assert(std::ranges::is_sorted(kCauses, {}, &CauseRow::message));

double value_of(const Limit& limit, const CauseLimits& limits) noexcept {
  const auto* const member = std::get_if<double CauseLimits::*>(&limit);
  return member != nullptr ? limits.*(*member) : std::get<double>(limit);
}

bool is_judged(Pulses pulses, bool enabled) noexcept {
  return pulses == Pulses::Any || enabled == (pulses == Pulses::On);
}

}  // namespace

std::span<const CauseRow> cause_rows() noexcept {
  return kCauses;
}

bool CauseMonitor::judge(std::size_t row, double duration, const Observed& observed,
                         const CauseLimits& limits) noexcept {
  const CauseRow& cause = kCauses[row];
  State& state = states_[row];
  const double beyond = observed.*cause.quantity - drive::value_of(cause.threshold, limits);
  const double distance = cause.side == Side::Above ? beyond : -beyond;
  const bool holds =
      is_judged(cause.pulses, observed.pulses_enabled) && distance > (state.present ? -cause.hysteresis : 0.0);
  state.time = holds ? state.time + duration : 0.0;
  state.present = holds && (state.present || elapsed(state.time, drive::value_of(cause.delay, limits)));
  return state.present;
}

std::uint32_t CauseMonitor::value_of(const CauseRow& row, const Observed& observed) noexcept {
  constexpr double kHighest = 4294967295.0;
  if (row.value == nullptr) return 0;
  return static_cast<std::uint32_t>(std::clamp(std::round(observed.*row.value * row.value_scale), 0.0, kHighest));
}

}  // namespace drive
