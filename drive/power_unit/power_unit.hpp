#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "drive/messages/cause.hpp"
#include "motor/data/supply_data.hpp"
#include "motor/drive_train.hpp"
#include "motor/lockstep/lockstep.hpp"

namespace drive {
namespace explanation {
struct Reason;
}

/// The power unit on its DC link: peaks of a cycle, what it switches the pulses off for by itself, temperatures
/// and energies.
class PowerUnit {
 public:
  struct Settings {
    using Block = PowerUnit;

    double current_threshold = 0.0;  ///< p2170 (A rms)
    double link_threshold = 0.0;     ///< p2172 (V)
  };

  /// On a link at @p dc_voltage (V).
  PowerUnit(const motor::InverterData& inverter, const motor::SupplyData& supply, double dc_voltage) noexcept
      : trip_current_{inverter.trip_current},
        overvoltage_{supply.overvoltage},
        undervoltage_{supply.undervoltage},
        dc_voltage_{dc_voltage} {}

  void begin_cycle() noexcept {
    peak_current_ = 0.0;
    tripped_phases_ = 0;
    highest_dc_voltage_ = 0.0;
    lowest_dc_voltage_ = dc_voltage_;
  }
  /// Steps have ended with the link as @p link tells, @p sums since the cycle began, the last of them with @p seen
  /// and, in the stator frame, @p current (A). False if the pulses go off, without waiting for the end of the
  /// cycle.
  bool watch(const motor::RunResult& link, const motor::StepSums<double>& sums, const motor::Signals& seen,
             const motor::SpaceVector& current) noexcept {
    dc_voltage_ = link.last_dc_voltage;
    highest_dc_voltage_ = std::max(highest_dc_voltage_, link.highest_dc_voltage);
    lowest_dc_voltage_ = std::min(lowest_dc_voltage_, link.lowest_dc_voltage);
    peak_current_ = sums.peak_current;
    energy_drawn_ = sums.drawn;
    energy_fed_back_ = sums.fed_back;
    const bool tripped = seen.current > trip_current_;
    if (tripped) note_phases(current);
    return !(dc_voltage_ > overvoltage_ || tripped);
  }
  /// At the end of a cycle that ended with @p signals.
  void observe(const motor::Signals& signals) noexcept {
    overload_ = signals.overload;
    heat_sink_ = signals.heat_sink_temperature;
    chip_rise_ = signals.chip_temperature - signals.heat_sink_temperature;
  }
  /// The link is at @p dc_voltage (V) while the axis rests.
  void rest(double dc_voltage) noexcept { dc_voltage_ = dc_voltage; }
  /// Counts the energies on from @p drawn and @p fed_back (J, not negative), those of a former life.
  void continue_energy(double drawn, double fed_back) noexcept {
    energy_drawn_ = drawn;
    energy_fed_back_ = fed_back;
  }

  double dc_voltage() const noexcept { return dc_voltage_; }                  ///< r0070 (V)
  bool has_link() const noexcept { return dc_voltage_ >= undervoltage_; }     ///< it has its voltage
  double energy_drawn() const noexcept { return energy_drawn_; }              ///< at the terminals (J)
  double energy_fed_back() const noexcept { return energy_fed_back_; }        ///< the same, not negative
  double peak_current() const noexcept { return peak_current_; }              ///< of the cycle (A)
  double tripped_phases() const noexcept { return tripped_phases_; }          ///< bits 0..2
  double highest_dc_voltage() const noexcept { return highest_dc_voltage_; }  ///< of the cycle (V)
  double lowest_dc_voltage() const noexcept { return lowest_dc_voltage_; }    ///< of the cycle (V)
  double overload() const noexcept { return overload_; }                      ///< r0036, 1 = 100 %
  double heat_sink() const noexcept { return heat_sink_; }                    ///< (°C)
  double chip_rise() const noexcept { return chip_rise_; }                    ///< above the heat sink (K)
  double trip_current() const noexcept { return trip_current_; }              ///< (A peak)
  double overvoltage() const noexcept { return overvoltage_; }                ///< trip voltage (V)
  double undervoltage() const noexcept { return undervoltage_; }              ///< trip voltage (V)

  /// Its reasons that an axis does not turn.
  static std::span<const explanation::Reason> reasons() noexcept;

  Settings settings{};

 private:
  void note_phases(const motor::SpaceVector& current) noexcept {
    const auto phases = motor::phase_values(current);
    for (std::size_t i = 0; i < phases.size(); ++i)
      if (std::abs(phases[i]) > trip_current_) tripped_phases_ |= 1U << i;
  }

  double trip_current_;
  double overvoltage_;
  double undervoltage_;
  double dc_voltage_;
  double peak_current_ = 0.0;
  double highest_dc_voltage_ = 0.0;
  double lowest_dc_voltage_ = 0.0;
  double energy_drawn_ = 0.0;
  double energy_fed_back_ = 0.0;
  unsigned tripped_phases_ = 0;
  double overload_ = 0.0;
  double heat_sink_ = 0.0;
  double chip_rise_ = 0.0;
};

// clang-format off
template <>
inline constexpr auto causes_of<PowerUnit> = std::array{
    CauseRow<PowerUnit>{7805, &PowerUnit::overload, Side::Above, 0.95, 0.02, cause::kAtOnce, Pulses::Any, &PowerUnit::overload, 16384.0, "r0036 at 95 %, the factory value of p0294"},
    CauseRow<PowerUnit>{30001, &PowerUnit::peak_current, Side::Above, &PowerUnit::trip_current, cause::kNone, cause::kAtOnce, Pulses::Any, &PowerUnit::tripped_phases, 1.0, "trip current of the power unit"},
    CauseRow<PowerUnit>{30002, &PowerUnit::highest_dc_voltage, Side::Above, &PowerUnit::overvoltage, cause::kNone, cause::kAtOnce, Pulses::On, &PowerUnit::highest_dc_voltage, 10.0, "trip voltage of the power unit"},
    CauseRow<PowerUnit>{30003, &PowerUnit::lowest_dc_voltage, Side::Below, &PowerUnit::undervoltage, cause::kNone, cause::kAtOnce, Pulses::On, &PowerUnit::lowest_dc_voltage, 10.0, "trip voltage of the power unit"},
    CauseRow<PowerUnit>{30004, &PowerUnit::heat_sink, Side::Above, 95.0, 5.0, cause::kAtOnce, Pulses::Any, &PowerUnit::heat_sink, 100.0, "heat sink, plausible"},
    CauseRow<PowerUnit>{30005, &PowerUnit::overload, Side::Above, 1.0, 0.05, cause::kAtOnce, Pulses::Any, &PowerUnit::overload, 16384.0, "r0036 at 100 %"},
    CauseRow<PowerUnit>{30016, &PowerUnit::lowest_dc_voltage, Side::Below, &PowerUnit::undervoltage, 10.0, cause::kAtOnce, Pulses::Off, &PowerUnit::lowest_dc_voltage, 1.0, "trip voltage of the power unit"},
    CauseRow<PowerUnit>{30025, &PowerUnit::chip_rise, Side::Above, 95.0, 5.0, cause::kAtOnce, Pulses::Any, &PowerUnit::chip_rise, 100.0, "chip above heat sink, plausible"},
    CauseRow<PowerUnit>{30502, &PowerUnit::highest_dc_voltage, Side::Above, &PowerUnit::overvoltage, 10.0, cause::kAtOnce, Pulses::Off, &PowerUnit::highest_dc_voltage, 1.0, "trip voltage of the power unit"},
};
// clang-format on

}  // namespace drive
