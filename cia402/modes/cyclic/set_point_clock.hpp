#pragma once

#include <cstdint>

#include "cia402/modes/cyclic/cyclic_settings.hpp"

namespace cia402 {

/// Where the demand is between two set-points.
enum class SetPointPhase : std::uint8_t {
  None,     ///< there was no set-point
  OnTime,   ///< less than T after the last one
  Held,     ///< T is over, and nobody has to send another one
  Late,     ///< the first one that was due is missing
  Missing,  ///< the second one too
};

/// The time since the last set-point, and how many that were due have not come.
///
/// Phases change at the exact instants. A set-point counts as missed when it has not come a cycle after it was
/// due, or half a period where that is shorter: to be late by the jitter of SYNC is not to be missing.
class SetPointClock {
 public:
  /// No set-point any more.
  void forget() noexcept { *this = SetPointClock{}; }
  /// There is one, and the next is due after @p period.
  void take(TimeNs period) noexcept;
  /// Until the phase changes; TimeNs::max() if it does not.
  TimeNs until_change() const noexcept;
  /// Time goes on by @p by, at most until_change(). Only with @p is_supervised a set-point can be due.
  void advance(TimeNs by, bool is_supervised) noexcept;

  SetPointPhase phase() const noexcept { return phase_; }
  /// Whether the last set-point leads the demand.
  bool is_led() const noexcept { return phase_ != SetPointPhase::None && phase_ != SetPointPhase::Missing; }
  TimeNs period() const noexcept { return period_; }    ///< of the last set-point
  TimeNs elapsed() const noexcept { return elapsed_; }  ///< since then
  /// In a row.
  std::uint32_t missed() const noexcept { return missed_; }
  /// Whether that is what @p settings say is too many.
  bool is_lost(const CyclicSettings& settings) const noexcept {
    return settings.missed_set_points != 0 && missed_ >= settings.missed_set_points;
  }

 private:
  SetPointPhase phase_ = SetPointPhase::None;
  TimeNs period_ = kCycleTime;
  TimeNs elapsed_{};
  std::uint32_t missed_ = 0;
};

}  // namespace cia402
