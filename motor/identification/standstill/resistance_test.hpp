#pragma once

#include <cstdint>

#include "motor/identification/standstill/bench/standstill_bench.hpp"
#include "motor/identification/standstill/bench/steady_mean.hpp"

namespace motor {

/// A direct current along the axis of the bench, looked at between the phases that carry the most of it: there the
/// valves lose a constant voltage, whatever they do in the third phase. Two of them give the resistance and that
/// voltage.
class ResistanceTest {
 public:
  enum class Level : std::uint8_t { Lower, Upper };

  explicit ResistanceTest(Level level) noexcept : level_{level} {}

  SpaceVector step(const Measurement& measured, StandstillBench& bench) noexcept;
  bool done() const noexcept { return done_; }

 private:
  DirectCurrent found(const StandstillBench& bench) const noexcept;
  void conclude(StandstillBench& bench) const noexcept;

  SteadyMean mean_{};
  Level level_;
  bool done_ = false;
};

}  // namespace motor
