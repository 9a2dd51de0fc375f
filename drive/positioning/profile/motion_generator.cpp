#include "drive/positioning/profile/motion_generator.hpp"

#include <algorithm>
#include <cmath>

namespace drive {
namespace {

constexpr double kRoundingError = 1e-6;  // cycles, of a time that is meant to be whole cycles

constexpr double kEndOfCycle = 1e-12;  // s, nearer than which a cycle is over

std::size_t whole_cycles(double seconds) noexcept {
  if (!(seconds > 0.0)) return 0;
  const double cycles = std::ceil(seconds / kMotionCycle - kRoundingError);
  return static_cast<std::size_t>(std::clamp(cycles, 1.0, static_cast<double>(MotionGenerator::kMostJerkCycles)));
}

}  // namespace

MotionGenerator::MotionGenerator(bool has_jerk_memory) : mean_{has_jerk_memory ? kMostJerkCycles : 0} {}

void MotionGenerator::place(double position) noexcept {
  trapezoid_.place(position);
  mean_.start(wanted_cycles_);
  is_at_rest_ = true;
}

void MotionGenerator::set_jerk_time(double seconds) noexcept {
  wanted_cycles_ = whole_cycles(seconds);
  if (is_at_rest_ && mean_.cycles() != wanted_cycles_) mean_.start(wanted_cycles_);
}

TrapezoidProfile::Advance MotionGenerator::advance(double dt, bool stops_at_braking_point,
                                                   bool stops_at_standstill) noexcept {
  if (!(dt > 0.0)) return {};
  const bool rests = is_at_rest_ && trapezoid_.stands();
  is_at_rest_ = rests;
  const TrapezoidProfile::Advance advance = trapezoid_.advance(dt, stops_at_braking_point, stops_at_standstill);
  elapsed_ += dt - advance.left;
  if (elapsed_ + kEndOfCycle < kMotionCycle) return advance;
  elapsed_ = 0.0;
  if (!rests) finish_cycle();
  return advance;
}

void MotionGenerator::finish_cycle() noexcept {
  mean_.add(trapezoid_.take_stretch(), trapezoid_.velocity());
  is_at_rest_ = stands();
  if (is_at_rest_ && mean_.cycles() != wanted_cycles_) mean_.start(wanted_cycles_);
}

}  // namespace drive
