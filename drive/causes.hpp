#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <variant>

namespace drive {

/// What the causes of faults and alarms are judged by, at the end of a process-data cycle.
struct Observed {
  bool pulses_enabled = false;
  double peak_current = 0.0;           ///< highest phase current of the cycle (A)
  double overcurrent_phases = 0.0;     ///< bits 0..2: phases above the trip current
  double dc_voltage = 0.0;             ///< highest of the cycle with the pulses on (V)
  double lowest_dc_voltage = 0.0;      ///< (V)
  double overload = 0.0;               ///< r0036, 1 = 100 %
  double heat_sink = 0.0;              ///< (°C)
  double chip_rise = 0.0;              ///< chip above heat sink (K)
  double motor_temperature = 0.0;      ///< of the sensor in the winding (°C)
  double motor_utilisation = 0.0;      ///< r0034, 1 = 100 %
  double stuck = 0.0;                  ///< 1 = at the torque limit, slower than p2175, although it should turn
  double overspeed = 0.0;              ///< speed beyond its limits (rad/s), negative within them
  double zero_mark_deviation = 0.0;    ///< of the last distance of zero marks (increments, absolute)
  double encoder_lost = 0.0;           ///< 1 = no signals
  double crossed_torque_limits = 0.0;  ///< lower limit above the upper one (N·m)
  double implausible_parameter = 0.0;  ///< number of a motor parameter, 0 = none
};

/// Limits that parameters, power unit and supply set.
struct CauseLimits {
  double trip_current = 0.0;          ///< (A peak)
  double overvoltage = 0.0;           ///< (V)
  double undervoltage = 0.0;          ///< (V)
  double temperature_alarm = 0.0;     ///< p0604 (°C)
  double temperature_fault = 0.0;     ///< p0605 (°C)
  double overspeed_hysteresis = 0.0;  ///< p2162 (rad/s)
  double blocked_delay = 0.0;         ///< p2177 (s)
};

/// A fixed number, or a limit that is set.
using Limit = std::variant<double, double CauseLimits::*>;

/// On which side of its threshold a quantity is a cause.
enum class Side : std::uint8_t { Above, Below };
/// With which pulses it is judged.
enum class Pulses : std::uint8_t { Any, On, Off };

/// One cause of a fault or an alarm in the physics of the axis. Rows of the same message follow each other.
struct CauseRow {
  std::uint16_t message;
  double Observed::*quantity;
  Side side;
  Limit threshold;
  double hysteresis;  ///< what the quantity has to go back by before the cause is gone
  Limit delay;        ///< so long it has to hold (s)
  Pulses pulses;
  double Observed::*value;  ///< what the message value shows, nullptr = 0
  double value_scale;
  std::string_view source;
};

/// Every cause, ascending by message.
std::span<const CauseRow> cause_rows() noexcept;
inline constexpr std::size_t kMostCauses = 24;

/// What follows from the causes of a message.
struct Verdict {
  std::uint16_t message;
  bool present;
  std::uint32_t value;
};

/// Judges the causes of one axis with their delays and hystereses.
class CauseMonitor {
 public:
  /// Calls @p tell with the verdict on each message that has a cause, and once when it has none any more,
  /// @p duration (s) after the last call.
  template <class Tell>
  void update(double duration, const Observed& observed, const CauseLimits& limits, const Tell& tell) noexcept {
    const std::span<const CauseRow> rows = cause_rows();
    Verdict verdict{};
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (rows[i].message != verdict.message) verdict = {rows[i].message, false, 0};
      if (judge(i, duration, observed, limits)) verdict = {rows[i].message, true, value_of(rows[i], observed)};
      const bool last = i + 1 == rows.size() || rows[i + 1].message != rows[i].message;
      if (last && (verdict.present || states_[i].told)) tell(verdict);
      if (last) states_[i].told = verdict.present;
    }
  }

  /// Whether a cause held at the last call.
  bool any_present() const noexcept { return std::ranges::any_of(states_, &State::present); }

 private:
  struct State {
    double time = 0.0;  // s, so long beyond the threshold
    bool present = false;
    bool told = false;  // of the message's last row: it was present at the last call
  };

  bool judge(std::size_t row, double duration, const Observed& observed, const CauseLimits& limits) noexcept;
  static std::uint32_t value_of(const CauseRow& row, const Observed& observed) noexcept;

  std::array<State, kMostCauses> states_{};
};

}  // namespace drive
