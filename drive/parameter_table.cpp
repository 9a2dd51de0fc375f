#include "drive/parameter_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "motor/drive_train.hpp"

namespace drive {
namespace {

using P = AxisParameters;
using enum Unit;
using enum Access;

constexpr double kFastest = 210000.0;  // rpm, limit of every speed parameter
constexpr double kHeavy = 20000000.0;  // N·m, limit of the torque parameters

// clang-format off
constexpr std::array kRows{
    ParameterRow{311, "p0311", "Rated motor speed", Rpm, 0.0, kFastest, 0.0, ReadOnly, &P::rated_speed},
    ParameterRow{322, "p0322", "Maximum motor speed", Rpm, 0.0, kFastest, 0.0, ReadOnly, &P::motor_maximum_speed},
    ParameterRow{333, "r0333", "Rated motor torque", NewtonMetre, 0.0, kHeavy, 0.0, ReadOnly, &P::rated_torque},
    ParameterRow{341, "p0341", "Motor moment of inertia", KilogramSquareMetre, 0.0, 100000.0, 0.0, ReadOnly, &P::motor_inertia},
    ParameterRow{408, "p0408", "Rotary encoder pulse number", None, 1.0, 16777215.0, 2048.0, ReadOnly, &P::encoder_pulses},
    ParameterRow{418, "p0418", "Encoder fine resolution", Bits, 2.0, 18.0, 11.0, ReadOnly, &P::encoder_fine_bits},
    ParameterRow{1082, "p1082", "Maximum speed", Rpm, 0.0, kFastest, 1500.0, PulsesOff, &P::maximum_speed},
    ParameterRow{1120, "p1120", "Ramp-up time", Seconds, 0.0, 999999.0, 10.0, Always, &P::ramp_up_time},
    ParameterRow{1121, "p1121", "Ramp-down time", Seconds, 0.0, 999999.0, 10.0, Always, &P::ramp_down_time},
    ParameterRow{1135, "p1135", "OFF3 ramp-down time", Seconds, 0.0, 600.0, 0.0, Always, &P::off3_ramp_down_time},
    ParameterRow{1226, "p1226", "Standstill speed threshold", Rpm, 0.0, kFastest, 20.0, Always, &P::standstill_threshold},
    ParameterRow{1227, "p1227", "Standstill monitoring time", Seconds, 0.0, 300.0, 4.0, Always, &P::standstill_monitoring_time},
    ParameterRow{1228, "p1228", "Pulse suppression delay", Seconds, 0.0, 299.0, 0.01, Always, &P::pulse_suppression_delay},
    ParameterRow{1460, "p1460", "Speed controller P gain", NewtonMetreSecondPerRadian, 0.0, 999999.0, 0.3, Always, &P::speed_gain},
    ParameterRow{1462, "p1462", "Speed controller integral time", Milliseconds, 0.0, 100000.0, 20.0, Always, &P::speed_integral_time},
    ParameterRow{1520, "p1520", "Torque limit upper", NewtonMetre, -1000000.0, kHeavy, 0.0, Always, &P::upper_torque_limit},
    ParameterRow{1521, "p1521", "Torque limit lower", NewtonMetre, -kHeavy, 1000000.0, 0.0, Always, &P::lower_torque_limit},
    ParameterRow{2000, "p2000", "Reference speed", Rpm, 6.0, kFastest, 3000.0, PulsesOff, &P::reference_speed},
    ParameterRow{2003, "p2003", "Reference torque", NewtonMetre, 0.01, kHeavy, 1.0, PulsesOff, &P::reference_torque},
    ParameterRow{2161, "p2161", "Speed threshold 3", Rpm, 0.0, kFastest, 5.0, Always, &P::zero_speed_threshold},
    ParameterRow{2162, "p2162", "Overspeed hysteresis", Rpm, 0.0, 60000.0, 0.0, Always, &P::overspeed_hysteresis},
    ParameterRow{2163, "p2163", "Speed threshold 4", Rpm, 0.0, kFastest, 90.0, Always, &P::target_window},
    ParameterRow{2164, "p2164", "Hysteresis 4", Rpm, 0.0, 200.0, 2.0, Always, &P::target_hysteresis},
    ParameterRow{2166, "p2166", "Off delay speed reached", Milliseconds, 0.0, 10000.0, 200.0, Always, &P::target_off_delay},
    ParameterRow{2175, "p2175", "Motor blocked speed threshold", Rpm, 0.0, kFastest, 120.0, Always, &P::blocked_speed_threshold},
    ParameterRow{2177, "p2177", "Motor blocked delay time", Seconds, 0.0, 65.0, 1.0, Always, &P::blocked_delay},
    ParameterRow{8641, "p8641", "CAN abort connection option code", None, 0.0, 3.0, 3.0, PulsesOff, &P::abort_connection_option},
    ParameterRow{8791, "p8791", "CAN stop option code", None, -1.0, 3.0, -1.0, Always, &P::halt_option},
};
// clang-format on

constexpr auto kNumberOrder = [](const ParameterRow& a, const ParameterRow& b) { return a.number < b.number; };
static_assert(std::is_sorted(kRows.begin(), kRows.end(), kNumberOrder), "lookup is a binary search");
static_assert(std::adjacent_find(kRows.begin(), kRows.end(), [](const auto& a, const auto& b) {
                return a.number == b.number;
              }) == kRows.end());
static_assert(std::all_of(kRows.begin(), kRows.end(), [](const ParameterRow& row) {
  return row.minimum <= row.factory && row.factory <= row.maximum;
}));

/// Undoes the rounding that the way through SI units leaves in the last digits.
double shown(double value) noexcept {
  constexpr double kDigits = 1e9;
  return std::abs(value) < 1e6 ? std::round(value * kDigits) / kDigits : value;
}

double get(const AxisParameters& parameters, const ParameterRow& row) noexcept {
  return std::visit([&](auto member) { return static_cast<double>(parameters.*member); }, row.member);
}

void set(AxisParameters& parameters, const ParameterRow& row, double value) noexcept {
  const double si = value * row_of(row.unit).si;
  if (const auto* number = std::get_if<double AxisParameters::*>(&row.member)) parameters.*(*number) = si;
  if (const auto* code = std::get_if<std::int32_t AxisParameters::*>(&row.member))
    parameters.*(*code) = static_cast<std::int32_t>(si);
}

/// What speaks against @p value, apart from the access.
std::optional<ParameterError::Reason> refusal(const ParameterRow& row, double value) noexcept {
  using Reason = ParameterError::Reason;
  if (!(value >= row.minimum)) return Reason::BelowMinimum;  // also refuses what is no number
  if (value > row.maximum) return Reason::AboveMaximum;
  const bool integer = std::holds_alternative<std::int32_t AxisParameters::*>(row.member);
  if (integer && std::abs(value - std::trunc(value)) > 0.0) return Reason::NotAnInteger;
  return std::nullopt;
}

}  // namespace

std::string message(const ParameterError& error) {
  using Reason = ParameterError::Reason;
  if (error.row == nullptr) return fmt::format("p{:04}: no such parameter", error.number);
  const ParameterRow& row = *error.row;
  const std::string_view space = row_of(row.unit).text.empty() ? "" : " ";
  switch (error.reason) {
    case Reason::Unknown:
      break;
    case Reason::ReadOnly:
      return fmt::format("{}: read only", row.text);
    case Reason::PulsesEnabled:
      return fmt::format("{}: cannot be written while the pulses are enabled", row.text);
    case Reason::NotAnInteger:
      return fmt::format("{}: expected an integer {}..{}", row.text, row.minimum, row.maximum);
    case Reason::BelowMinimum:
      return fmt::format("{}: below the minimum of {}{}{}", row.text, row.minimum, space, row_of(row.unit).text);
    case Reason::AboveMaximum:
      return fmt::format("{}: above the maximum of {}{}{}", row.text, row.maximum, space, row_of(row.unit).text);
  }
  return fmt::format("{}: no such parameter", row.text);
}

std::span<const ParameterRow> parameter_rows() noexcept {
  return kRows;
}

const ParameterRow* find_parameter(std::uint16_t number) noexcept {
  const auto row = std::lower_bound(kRows.begin(), kRows.end(), number,
                                    [](const ParameterRow& r, std::uint16_t n) { return r.number < n; });
  return row != kRows.end() && row->number == number ? &*row : nullptr;
}

const ParameterRow* find_parameter(std::string_view text) noexcept {
  const auto row = std::find_if(kRows.begin(), kRows.end(), [&](const ParameterRow& r) { return r.text == text; });
  return row != kRows.end() ? &*row : nullptr;
}

tl::expected<double, ParameterError> read(const AxisParameters& parameters, std::uint16_t number) noexcept {
  const ParameterRow* row = find_parameter(number);
  if (row == nullptr) return tl::unexpected{ParameterError{ParameterError::Reason::Unknown, number, nullptr}};
  return shown(get(parameters, *row) / row_of(row->unit).si);
}

tl::expected<void, ParameterError> write(AxisParameters& parameters, std::uint16_t number, double value) noexcept {
  using Reason = ParameterError::Reason;
  const ParameterRow* row = find_parameter(number);
  if (row == nullptr) return tl::unexpected{ParameterError{Reason::Unknown, number, nullptr}};
  if (row->access == Access::ReadOnly) return tl::unexpected{ParameterError{Reason::ReadOnly, number, row}};
  if (const auto reason = refusal(*row, value)) return tl::unexpected{ParameterError{*reason, number, row}};
  set(parameters, *row, value);
  return {};
}

AxisParameters commissioned_parameters(const motor::MachineData& machine, const motor::Load& load) noexcept {
  AxisParameters parameters{};
  for (const ParameterRow& row : kRows) set(parameters, row, row.factory);
  parameters.rated_speed = machine.rated_speed;
  parameters.motor_maximum_speed = machine.maximum_speed;
  parameters.rated_torque = machine.rated_torque;
  parameters.motor_inertia = machine.inertia;
  parameters.encoder_pulses = static_cast<std::int32_t>(machine.encoder_pulses);
  parameters.encoder_fine_bits = machine.encoder_fine_bits;
  parameters.maximum_speed = machine.maximum_speed;
  parameters.overspeed_hysteresis = std::min(0.1 * machine.maximum_speed, 60000.0 * kRpm);
  const motor::SpeedControllerGains gains = motor::default_gains(machine, load);
  parameters.speed_gain = gains.proportional;
  parameters.speed_integral_time = gains.integral_time;
  parameters.upper_torque_limit = machine.maximum_torque;
  parameters.lower_torque_limit = -machine.maximum_torque;
  parameters.reference_speed = machine.rated_speed;
  parameters.reference_torque = machine.rated_torque;
  return parameters;
}

}  // namespace drive
