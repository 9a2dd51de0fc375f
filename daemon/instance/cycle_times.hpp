#pragma once

#include <cstdint>

#include "daemon/base/histogram.hpp"
#include "libcanopen/base/time.hpp"

namespace axisd {

/// How punctual the process-data cycles of a unit are, and what they cost, by the clock of the machine. Cycles
/// that are made up for together count as one turn.
class CycleTimes {
 public:
  /// Cycles of @p period that were due at @p due were begun at @p begin and are over at @p end.
  void note(canopen::TimePoint due, canopen::TimePoint begin, canopen::TimePoint end,
            canopen::Duration period) noexcept {
    lateness_.note(begin - due);
    duration_.note(end - begin);
    if (end - due > period) ++overruns_;
  }

  /// From when cycles were due until the turn that ran them began.
  const Histogram& lateness() const noexcept { return lateness_; }
  /// From the beginning of that turn until they were over.
  const Histogram& duration() const noexcept { return duration_; }
  /// Turns that were over only when the next cycle was due.
  std::uint64_t overruns() const noexcept { return overruns_; }

 private:
  Histogram lateness_;
  Histogram duration_;
  std::uint64_t overruns_ = 0;
};

}  // namespace axisd
