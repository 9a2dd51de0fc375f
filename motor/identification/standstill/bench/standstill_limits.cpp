#include "motor/identification/standstill/bench/standstill_limits.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace motor {
namespace {

/// What a value is a share of.
enum class Base : std::uint8_t { Impedance, Inductance, Seconds };

struct Limit {
  StandstillFault fault;
  double (*value)(const StandstillResult&) noexcept;
  Base base;
  double low;
  double high;
};

constexpr std::array kLimits{
    Limit{StandstillFault::StatorResistance,
          [](const StandstillResult& r) noexcept { return r.stator_resistance; }, Base::Impedance, 0.001, 1.0},
    Limit{StandstillFault::StatorReactance, [](const StandstillResult& r) noexcept { return r.d_inductance; },
          Base::Inductance, 0.01, 3.0},
    Limit{StandstillFault::StatorReactance, [](const StandstillResult& r) noexcept { return r.q_inductance; },
          Base::Inductance, 0.01, 3.0},
    Limit{StandstillFault::Leakage, [](const StandstillResult& r) noexcept { return r.leakage; }, Base::Inductance,
          0.04, 0.5},
    Limit{StandstillFault::RotorResistance, [](const StandstillResult& r) noexcept { return r.rotor_resistance; },
          Base::Impedance, 0.001, 1.0},
    Limit{StandstillFault::MainReactance,
          [](const StandstillResult& r) noexcept { return r.magnetising_inductance; }, Base::Inductance, 0.5, 5.0},
    Limit{StandstillFault::RotorTimeConstant,
          [](const StandstillResult& r) noexcept {
            return r.rotor_resistance > 0.0 ? r.magnetising_inductance / r.rotor_resistance : 0.0;
          },
          Base::Seconds, 0.01, 5.0},
};

}  // namespace

StandstillFault find_implausible(const MachineData& machine, const StandstillResult& result) noexcept {
  const double impedance = machine.rated_voltage / (std::numbers::sqrt3 * machine.rated_current);
  const double inductance = impedance / (2.0 * std::numbers::pi * machine.rated_frequency);
  const std::array bases{impedance, inductance, 1.0};
  for (const Limit& row : kLimits) {
    const double value = row.value(result);
    if (std::fpclassify(value) == FP_ZERO) continue;
    const double share = value / bases[static_cast<std::size_t>(row.base)];
    if (!(share >= row.low && share <= row.high)) return row.fault;
  }
  return StandstillFault::None;
}

}  // namespace motor
