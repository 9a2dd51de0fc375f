#include "motor/identification/standstill/curve_test.hpp"

#include <algorithm>
#include <numbers>

#include "motor/identification/model/field_model.hpp"

namespace motor {
namespace {

constexpr double kLower = 0.2;                      // of the magnetising current, where nothing saturates
constexpr double kHighest = 1.8;                    // of it, if the test current allows
constexpr std::array kShares{0.3, 0.5, 0.75, 1.0};  // of the highest current
constexpr double kWindow = 8.0;                     // rotor time constants
constexpr int kTailShare = 8;                       // of the window
constexpr double kShortest = 0.3;                   // s
constexpr double kLongest = 6.0;                    // s

double magnetising_current(const StandstillBench& bench) noexcept {
  return std::numbers::sqrt2 * bench.task.machine.induction.magnetising_current;
}

double highest_current(const StandstillBench& bench) noexcept {
  return std::min(kHighest * magnetising_current(bench), bench.test_current);
}

}  // namespace

SpaceVector CurveTest::step(const Measurement& measured, StandstillBench& bench) noexcept {
  if (window_ > 0) {
    take(measured, bench);
  } else {
    start_.step(measured, bench.axis);
    if (start_.steady()) begin(bench);
    if (start_.overdue()) bench.fault = StandstillFault::MainReactance;
  }
  before_ = dot(measured.current, bench.axis);
  const double lower = std::min(kLower * magnetising_current(bench), bench.test_current);
  const double current = window_ > 0 ? kShares[std::min(level_, kLevels - 1)] * highest_current(bench) : lower;
  return bench.currents.step(current * bench.axis, measured);
}

void CurveTest::begin(const StandstillBench& bench) noexcept {
  const StandstillResult& found = bench.result;
  const double warm = found.rotor_resistance * bench.warm_resistance / found.stator_resistance;
  window_ = steps_in(std::clamp(kWindow * found.magnetising_inductance / warm, kShortest, kLongest));
  tail_ = window_ / kTailShare;
  start_flux_ = found.magnetising_inductance * dot(start_.current(), bench.axis);
}

void CurveTest::take(const Measurement& measured, StandstillBench& bench) noexcept {
  const double now = dot(measured.current, bench.axis);
  const double current = 0.5 * (now + before_) - dot(start_.current(), bench.axis);
  const double beyond = dot(measured.voltage - start_.voltage(), bench.axis) - bench.warm_resistance * current;
  flux_ += kControlPeriod * beyond - bench.result.leakage * (now - before_);
  if (++taken_ > window_ - tail_) {
    rate_ += beyond;
    current_ += now;
  }
  if (taken_ == window_) end_level(bench);
}

/// What is left of the voltage when the flux stands is no flux: resistance and valves are not known exactly.
void CurveTest::end_level(StandstillBench& bench) noexcept {
  flux_ -= kControlPeriod * window_ * rate_ / tail_;
  points_[level_] = {start_flux_ + flux_, current_ / tail_};
  taken_ = 0;
  rate_ = current_ = 0.0;
  if (++level_ == kLevels) conclude(bench);
}

void CurveTest::conclude(StandstillBench& bench) const noexcept {
  const double flux = rated_flux(bench.task.machine);
  SaturationCurve& curve = bench.result.curve;
  for (std::size_t i = 0; i < kLevels; ++i) {
    curve.flux[i] = points_[i].flux / flux;
    curve.magnetising_current[i] = points_[i].current / magnetising_current(bench);
  }
  const bool rises = points_[0].flux > 0.0 && std::ranges::is_sorted(points_, {}, &FluxPoint::flux);
  if (!rises || !fit_saturation(points_, flux, curve)) bench.fault = StandstillFault::MainReactance;
}

}  // namespace motor
